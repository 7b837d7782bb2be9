// Lists of the sources that may light a tile of the viewport: src/plan/tile_lists.h says how they are laid out.

uniform highp usampler2D ew_list_texture;

int ew_list_entry(int i)
{
    return int(texelFetch(ew_list_texture, ivec2(i % EW_TEXTURE_WIDTH, i / EW_TEXTURE_WIDTH), 0).r);
}

// The first row, in the table of lists, of the tile at a pixel of the viewport, or of the nodes around it.
int ew_find_tile(ivec2 pixel)
{
    ivec2 tile = (pixel + EW_NODE_MARGIN * EW_CELL_SIZE) >> ew_grid.tiles.y;
    return (tile.y * ew_grid.tiles.x + tile.x) * EW_KIND_COUNT;
}

// What ew_find_tile says of the fragment. It is the same for a whole patch.
#ifndef EW_PATCHES
int ew_tile;
#elif defined(EW_VERTEX_STAGE)
flat out int ew_tile;
#else
flat in int ew_tile;
#endif
