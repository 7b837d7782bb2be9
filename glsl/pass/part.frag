// The light of a part of the sources at a pixel: sum B_i color_i, and B as the fourth component; or with EW_EVALUATIONS, how many evaluations
// it took. That of all parts is summed up in a texture, which begins at the viewport's corner: one shader for all sources would take long to
// compile.

out vec4 ew_of_part;

void main()
{
    ivec2 place = ew_grid.viewport.xy + ivec2(gl_FragCoord.xy);
    vec2 pixel = vec2(place) + 0.5 - ew_frame.pixel_center.xy;
    ew_segment segment = ew_pixel_segment(pixel);
#if defined(EW_LISTS) && !defined(EW_PATCHES)
    ew_tile_row = ew_find_tile_row(place - ew_grid.viewport.xy);
#endif
#ifdef EW_DEPTH_MULTISAMPLE
    ew_shaded_samples shaded = ew_samples_to_shade(place); // one surface
    segment.end = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_depth_to_shade(shaded, place, shaded.first)));
#elif defined(EW_DEPTH)
    segment.end = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_window_depth(place)));
#endif
    ew_of_part = ew_integrate_all(segment);
#ifdef EW_EVALUATIONS
    ew_of_part = vec4(float(ew_evaluation_count), 0.0, 0.0, 0.0);
#endif
}
