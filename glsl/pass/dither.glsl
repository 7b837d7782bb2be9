// Noise that keeps faint glow from banding on a target of 8 bits a channel.
//
// The target rounds to the nearest of its steps. With noise spread evenly over half a step to either side, it rounds to the step
// above as often as the value is nearer to that one, so that the mean stays the value; and where there is no light, to 0.

// In [0, 1), spread evenly, in every 3 x 3 pixels already: Jimenez, "Next Generation Post Processing in Call of Duty: Advanced
// Warfare" (SIGGRAPH 2014), interleaved gradient noise.
float ew_gradient_noise(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

#ifdef EW_DITHER_SRGB
// The sRGB transfer functions (IEC 61966-2-1).
vec3 ew_encode_srgb(vec3 linear)
{
    return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

vec3 ew_decode_srgb(vec3 encoded)
{
    return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), step(0.04045, encoded));
}
#endif

vec3 ew_dither(vec3 radiance)
{
    float noise = (ew_gradient_noise(gl_FragCoord.xy) - 0.5) / 255.0;
#ifdef EW_DITHER_SRGB
    // The steps are even in encoded values; exact over black, finer than a step over brighter backgrounds.
    return ew_decode_srgb(max(ew_encode_srgb(min(radiance, 1.0)) + noise, 0.0));
#else
    return max(radiance + noise, 0.0);
#endif
}
