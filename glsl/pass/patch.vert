// A patch of the grid as a point of its size, if it is drawn by this pass: EW_INTERPOLATED, the smooth ones, and else the cells that
// are rough or, with ew_draws_torn, torn.

uniform sampler2D ew_cell_texture;
uniform sampler2D ew_block_texture;
uniform int ew_stride;
uniform bool ew_draws_torn;

bool ew_is_drawn(const ivec2 place)
{
#ifdef EW_INTERPOLATED
    if (ew_stride > 1) return texelFetch(ew_block_texture, place, 0).r == EW_SMOOTH;
    return texelFetch(ew_cell_texture, place, 0).r == EW_SMOOTH && texelFetch(ew_block_texture, place / EW_BLOCK_CELLS, 0).r != EW_SMOOTH;
#else
    float drawn_class = texelFetch(ew_cell_texture, place, 0).r;
    return abs(drawn_class - (ew_draws_torn ? EW_TORN : EW_ROUGH)) < 0.1;
#endif
}

void main()
{
    int width = ew_stride * EW_CELL_SIZE;
    ivec2 count = (ew_grid.viewport.zw + width - 1) / width;
    ivec2 place = ivec2(gl_VertexID % count.x, gl_VertexID / count.x);
    vec2 center = (vec2(place) + 0.5) / vec2(count);
    gl_Position = ew_is_drawn(place) ? vec4(2.0 * center - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = float(width);
#ifdef EW_INTERPOLATED
    ew_fit(ew_first_node(place, ew_stride), ew_stride);
    ew_patch = vec3(vec2(ew_grid.viewport.xy + place * width) + 0.5, 1.0 / float(width));
#else
    ew_copy_varyings();
#ifdef EW_LISTS
    ew_tile_row = ew_find_tile_row(place * width);
#endif
#endif
}
