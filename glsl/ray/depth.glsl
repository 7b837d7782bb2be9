// Where the opaque scene ends the ray.

// s_max: the ray parameter of the opaque surface at window depth `depth` behind `pixel` (relative to the pixel of NDC (0, 0)), in
// [0, 1].
//
// Window depth d is z / w in clip space, and z and w are linear in s; with d_S, w_S and d_E, w_E their values at S and E,
//
//     s = w_S (d - d_S) / (w_S (d - d_S) + w_E (d_E - d)),
//
// which holds for every projection, reversed and infinite ones too, and divides only inside the interval, by a positive
// number. d_S and d_E come as sums of a float and its rounding error, since d may be close to them.
float ew_parameter_of_depth(vec2 pixel, float depth)
{
    vec4 start = ew_frame.depth_start;
    vec4 end = ew_frame.depth_end;
    float behind_start = ew_frame.depth_scale.x * ((depth - start.x) - (start.y + dot(start.zw, pixel)));
    float before_end = ew_frame.depth_scale.y * ((end.x - depth) + (end.y + dot(end.zw, pixel)));
    // A depth that is no number ends the ray at S. Its bits tell: compilers may take !(x > 0.0) for x <= 0.0.
    bool is_number = (floatBitsToInt(depth) & 0x7fffffff) <= 0x7f800000;
    float inside = before_end > 0.0 ? behind_start / (behind_start + before_end) : 1.0;
    return is_number && behind_start > 0.0 ? inside : 0.0;
}

#ifdef EW_DEPTH_MULTISAMPLE
uniform sampler2DMS ew_depth_texture;
// The samples that this pass is for: from x on, before y.
uniform ivec2 ew_samples;

float ew_opaque_parameter(vec2 pixel, int sample_index)
{
    return ew_parameter_of_depth(pixel, texelFetch(ew_depth_texture, ivec2(gl_FragCoord.xy), sample_index).r);
}
#else
uniform sampler2D ew_depth_texture;

float ew_opaque_parameter(vec2 pixel)
{
    return ew_parameter_of_depth(pixel, texelFetch(ew_depth_texture, ivec2(gl_FragCoord.xy), 0).r);
}
#endif
