// Interleaved gradient noise, in [0, 1): it is spread evenly over every 3 x 3 pixels. Jimenez, "Next Generation Post Processing
// in Call of Duty: Advanced Warfare" (SIGGRAPH 2014).
float ew_gradient_noise(const vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}
