// Where the opaque scene ends the ray.

// What is added to `depth`.x, the larger part of the window depth at one end of the interval, for the ray through `pixel`.
float ew_depth_correction(const vec4 depth, const vec2 pixel)
{
    float rounding_error = depth.y;
    vec2 per_pixel = depth.zw;
    return rounding_error + dot(per_pixel, pixel);
}

// The ray parameter s_max, in [0, 1], of the opaque surface at window depth `depth`; `pixel` is relative to the pixel of NDC
// (0, 0).
//
// Window depth d is z / w in clip space, and z and w are linear in s. With d_S, w_S and d_E, w_E their values at S and E,
//
//     s = w_S (d - d_S) / (w_S (d - d_S) + w_E (d_E - d)).
//
// This holds for every projection, reversed and infinite ones included. Inside the interval the divisor is a sum of positive
// terms. d may be close to d_S or d_E, so both come as the sum of a float and its rounding error. With w = 1 it holds for view
// depth as well.
float ew_parameter_of_depth(const vec2 pixel, const float depth)
{
    vec4 start = ew_frame.depth_start;
    vec4 end = ew_frame.depth_end;
    float clip_w_start = ew_frame.depth_scale.x;
    float clip_w_end = ew_frame.depth_scale.y;
    float behind_start = clip_w_start * ((depth - start.x) - ew_depth_correction(start, pixel));
    float before_end = clip_w_end * ((end.x - depth) + ew_depth_correction(end, pixel));
    // A NaN ends the ray at S. It is recognised by its bits, because compilers may replace !(x > 0.0) by x <= 0.0.
    bool is_number = (floatBitsToInt(depth) & 0x7fffffff) <= 0x7f800000;
    float inside = before_end > 0.0 ? behind_start / (behind_start + before_end) : 1.0;
#ifdef EW_WORLD
    // Where there is no surface, what lies beyond the far plane shines, S included.
    float no_surface = ew_frame.depth_scale.z;
    bool is_open = clip_w_end > 0.0 ? depth >= no_surface : depth <= no_surface;
    if (is_number && is_open) return 1.0;
#endif
    return is_number && behind_start > 0.0 ? inside : 0.0;
}

// How much the parameter grows with window depth, at `depth`, if that is between those of S and E.
float ew_parameter_slope(const vec2 pixel, const float depth)
{
    vec4 start = ew_frame.depth_start;
    vec4 end = ew_frame.depth_end;
    float correction_start = ew_depth_correction(start, pixel);
    float correction_end = ew_depth_correction(end, pixel);
    float clip_w_start = ew_frame.depth_scale.x;
    float clip_w_end = ew_frame.depth_scale.y;
    float between = (end.x - start.x) + (correction_end - correction_start);
    float sum = clip_w_start * ((depth - start.x) - correction_start) + clip_w_end * ((end.x - depth) + correction_end);
    return abs(clip_w_start * clip_w_end * between / (sum * sum));
}

#ifdef EW_DEPTH_MULTISAMPLE
uniform sampler2DMS ew_depth_texture;
// The samples that this pass shades, from x up to but not including y.
uniform ivec2 ew_samples;

// The window depth of a sample of the target's pixel `place`.
float ew_window_depth(const ivec2 place, const int sample_index)
{
    return texelFetch(ew_depth_texture, place, sample_index).r;
}
#else
uniform sampler2D ew_depth_texture;

// The window depth of the target's pixel `place`.
float ew_window_depth(const ivec2 place)
{
    return texelFetch(ew_depth_texture, place, 0).r;
}
#endif
