// What light does to the target.
//
// The composite over the opaque scene is (1 - B) Cb + sum B_i color_i, thesis (4.8) with the background's weight kept from going
// negative, which blending with (ONE, ONE_MINUS_SRC_ALPHA) does.

// The largest half float: a colour beyond would be infinite in a 16-bit target.
const float EW_MAX_RADIANCE = 65504.0;

// The shader's output for sum B_i color_i and, as the fourth component, B.
vec4 ew_composite(const vec4 light)
{
#ifdef EW_LUMINANCE
    return vec4(light.a, 0.0, 0.0, 1.0);
#elif defined(EW_SOFT)
    return vec4(1.0 - exp(-min(light.rgb, EW_MAX_RADIANCE)), 1.0);
#else
    return vec4(min(light.rgb, EW_MAX_RADIANCE), min(light.a, 1.0));
#endif
}
