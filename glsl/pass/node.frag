// What is known of a node of the grid, at the ray through the pixel where it lies. Nodes beyond the viewport have rays, too.
//
// Without EW_FIELD: the node's light. With it: the field where the ray ends, which says how much of the light a step in depth
// makes; or EW_UNRESOLVED, where a source so thin shines nearby that it could slip through between the nodes.

// How far the nodes lie to the right of and above their cells' corners, in pixels.
uniform int ew_node_offset;

#ifdef EW_FIELD
out float ew_of_node;
#else
out vec4 ew_of_node;
#endif

#ifdef EW_DEPTH
#ifdef EW_DEPTH_MULTISAMPLE
#define EW_WINDOW_DEPTH(place) ew_window_depth(place, ew_samples.x)
#else
#define EW_WINDOW_DEPTH(place) ew_window_depth(place)
#endif

// The window depth at `place`. Beyond the viewport, where the host may have drawn nothing, the surface at its border goes on as
// a plane.
float ew_window_depth_around(const ivec2 place)
{
    ivec2 first = ew_grid.viewport.xy;
    ivec2 inside = clamp(place, first, first + ew_grid.viewport.zw - 1);
    ivec2 beyond = place - inside;
    float depth = EW_WINDOW_DEPTH(inside);
    if (beyond == ivec2(0)) return depth;
    float slope_x = depth - EW_WINDOW_DEPTH(inside - ivec2(sign(beyond.x), 0));
    float slope_y = depth - EW_WINDOW_DEPTH(inside - ivec2(0, sign(beyond.y)));
    return depth + float(abs(beyond.x)) * slope_x + float(abs(beyond.y)) * slope_y;
}
#endif

void main()
{
    ivec2 place = ew_grid.viewport.xy + (ivec2(gl_FragCoord.xy) - EW_NODE_MARGIN) * EW_CELL_SIZE + ew_node_offset;
    vec2 pixel = vec2(place) + 0.5 - ew_frame.pixel_center.xy;
    ew_segment segment = ew_pixel_segment(pixel);
#ifdef EW_LISTS
    ew_tile_row = ew_find_tile_row(place - ew_grid.viewport.xy);
#endif
#ifdef EW_DEPTH
    segment.end = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_window_depth_around(place)));
#endif
#ifdef EW_FIELD
    ew_of_node = ew_integrate_all(segment).a;
#else
    ew_of_node = ew_integrate_all(segment);
#endif
}
