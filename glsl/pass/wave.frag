// Energy waves: for each pixel the sum, over all sources, of
//
//     B_i = integral from 0 to s_max of  coefficient * weight / max(epsilon, distance(L(s))) * alpha / (s + beta)^2  ds,
//
// equations (18), (20), (21), and its composite over the opaque scene: (1 - B) Cb + sum B_i color_i, thesis (4.8) with the
// background's weight kept from going negative, which blending with (ONE, ONE_MINUS_SRC_ALPHA) does.

// The largest half float: a colour beyond would be infinite in a 16-bit target.
const float EW_MAX_RADIANCE = 65504.0;

out vec4 ew_color;

// What the light along a segment does to the target.
vec4 ew_shade(ew_segment segment)
{
    vec4 light = ew_integrate_all(segment);
#ifdef EW_LUMINANCE
    return vec4(light.a, 0.0, 0.0, 1.0);
#else
#ifdef EW_SOFT
    return vec4(1.0 - exp(-min(light.rgb, EW_MAX_RADIANCE)), 1.0);
#else
    return vec4(min(light.rgb, EW_MAX_RADIANCE), min(light.a, 1.0));
#endif
#endif
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - ew_frame.pixel_center.xy;
    vec4 ray = ew_frame.ray_center + pixel.x * ew_frame.ray_right + pixel.y * ew_frame.ray_up;
#ifdef EW_WORLD
    float span = ew_span();
#else
    const float span = 1.0;
#endif
    ew_segment segment = ew_segment(vec3(ray.xy, 0.0), vec3(ray.zw, -1.0), span);
    ew_view_depth = vec2(ew_frame.core_floor.y, 1.0);

#ifdef EW_DEPTH_MULTISAMPLE
    // The mean of what is done to the target, not of the depths: a pixel on a silhouette is no wall half way.
    ew_color = vec4(0.0);
    for (int i = ew_samples.x; i < ew_samples.y; ++i) {
        segment.end = ew_end_of_ray(ew_opaque_parameter(pixel, i));
        ew_color += ew_shade(segment);
    }
    ew_color /= float(ew_samples.y - ew_samples.x);
#else
#ifdef EW_DEPTH
    segment.end = ew_end_of_ray(ew_opaque_parameter(pixel));
#endif
    ew_color = ew_shade(segment);
#endif

#ifdef EW_DITHER
    ew_color.rgb = ew_dither(ew_color.rgb);
#endif
#ifdef EW_EVALUATIONS
    ew_color = vec4(float(ew_evaluation_count), 0.0, 0.0, 1.0);
#endif
}
