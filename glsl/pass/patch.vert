// A patch of the grid as a point of its size, if it is drawn by this pass: EW_INTERPOLATED, the smooth ones, and else the cells that
// are rough or, with ew_draws_torn, torn. With an ew_stride of 0, patches are quarters of cells. Software rasterisers compute both sides of
// every `if`, so the cells that a part of the sources does not light are not left to the fragment stage.

uniform sampler2D ew_cell_texture;
uniform sampler2D ew_block_texture;
uniform int ew_stride;
uniform bool ew_draws_torn;

bool ew_is_drawn(const ivec2 place)
{
#ifdef EW_INTERPOLATED
    if (ew_stride > 1) return ew_read_class(ew_block_texture, place) == EW_SMOOTH;
    return ew_read_class(ew_cell_texture, place) == EW_SMOOTH && ew_read_class(ew_block_texture, place / EW_BLOCK_CELLS) != EW_SMOOTH;
#else
    bool is_whole = ew_stride > 0;
    int cell_class = ew_read_class(ew_cell_texture, is_whole ? place : place / 2);
    if (!ew_draws_torn) return cell_class == EW_ROUGH;
    int quarter = 2 * (place.y & 1) + (place.x & 1);
    return cell_class <= EW_LAST_TORN && (is_whole || (cell_class >> quarter & 1) != 0);
#endif
}

void main()
{
    int width = ew_stride > 0 ? ew_stride * EW_CELL_SIZE : EW_CELL_SIZE / 2;
    ivec2 count = (ew_grid.viewport.zw + width - 1) / width;
    ivec2 place = ivec2(gl_VertexID % count.x, gl_VertexID / count.x);
    vec2 center = (vec2(place) + 0.5) / vec2(count);
    bool is_drawn = ew_is_drawn(place);
#ifdef EW_LISTS
    ew_tile_row = ew_find_tile_row(place * width);
#ifdef EW_PART
    is_drawn = is_drawn && !ew_are_lists_empty(ew_tile_row, EW_FIRST_LIST, EW_LAST_LIST);
#endif
#endif
    gl_Position = is_drawn ? vec4(2.0 * center - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = float(width);
#ifdef EW_INTERPOLATED
    ew_fit(ew_first_node(place, ew_stride), ew_stride);
    ew_patch = vec3(vec2(ew_grid.viewport.xy + place * width) + 0.5, 1.0 / float(width));
#else
    ew_copy_varyings();
#endif
}
