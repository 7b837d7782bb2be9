// Noise against the banding of faint glow on targets of 8, 10 or 11 bits a channel.
//
// The target rounds to the nearest of its steps. With noise spread evenly over half a step to either side, it rounds up as
// often as the value is closer to the step above, so the mean over neighbouring pixels stays the value. Where there is no
// light, 0 stays 0.

#ifdef EW_DITHER_SRGB
// The sRGB transfer functions (IEC 61966-2-1).
vec3 ew_encode_srgb(const vec3 linear)
{
    return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

vec3 ew_decode_srgb(const vec3 encoded)
{
    return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), step(0.04045, encoded));
}
#endif

// How far apart the values are that the target stores near `radiance`. A step of fixed point is the same everywhere. That of a
// small float grows with the power of two below the value; blue has a bit less, and below 2^-14 the steps are even.
vec3 ew_target_step(const vec3 radiance)
{
    vec3 power_of_two = exp2(floor(log2(max(radiance, exp2(-14.0)))));
    return ew_frame.pixel_center.z + ew_frame.pixel_center.w * vec3(1.0, 1.0, 2.0) * power_of_two;
}

// Linear radiance with noise of half a step to either side, for a target that stores it as it is or, with EW_DITHER_SRGB,
// encoded.
vec3 ew_dither(const vec3 radiance)
{
    float noise = ew_gradient_noise(gl_FragCoord.xy) - 0.5;
#ifdef EW_DITHER_SRGB
    // The steps are even in encoded values. Over black the noise is one step wide; over brighter backgrounds it is narrower.
    return ew_decode_srgb(max(ew_encode_srgb(min(radiance, 1.0)) + noise / 255.0, 0.0));
#else
    return max(radiance + noise * ew_target_step(radiance), 0.0);
#endif
}
