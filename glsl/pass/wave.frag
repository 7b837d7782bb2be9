// Energy waves: for each pixel the sum, over all sources, of
//
//     B_i = integral from 0 to s_max of  coefficient * weight / max(epsilon, distance(L(s))) * alpha / (s + beta)^2  ds,
//
// equations (18), (20), (21), and its composite over the opaque scene.

out vec4 ew_color;

void main()
{
    vec2 pixel = gl_FragCoord.xy - ew_frame.pixel_center.xy;
    ew_segment segment = ew_pixel_segment(pixel);
#if defined(EW_LISTS) && !defined(EW_PATCHES)
    ew_tile_row = ew_find_tile_row(ivec2(gl_FragCoord.xy) - ew_grid.viewport.xy);
#endif

#ifdef EW_DEPTH_MULTISAMPLE
    // The mean of what is done to the target, not of the depths: a pixel on a silhouette is no wall half way.
    ivec2 place = ivec2(gl_FragCoord.xy);
    ew_shaded_samples shaded = ew_samples_to_shade(place);
    int i = shaded.first;
    ew_color = vec4(0.0);
    do {
        segment.end = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_depth_to_shade(shaded, place, i)));
        ew_color += ew_composite(ew_integrate_all(segment));
    } while (++i < shaded.end);
    ew_color /= float(shaded.end - shaded.first);
#else
#ifdef EW_DEPTH
    segment.end = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_window_depth(ivec2(gl_FragCoord.xy))));
#endif
    ew_color = ew_composite(ew_integrate_all(segment));
#endif

#ifdef EW_DITHER
    ew_color.rgb = ew_dither(ew_color.rgb);
#endif
#ifdef EW_EVALUATIONS
    ew_color = vec4(float(ew_evaluation_count), 0.0, 0.0, 1.0);
#endif
}
