// Interleaved gradient noise in [0, 1): Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", 2014.
float peer_noise()
{
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}
