// Lists of the sources that may light a tile of the viewport: src/plan/tile_lists.h says how they are laid out.

#ifdef EW_SOURCE_TEXTURE
int ew_list_entry(const int i)
{
    return int(ew_source_unit(int(ew_grid.tolerance.z) + (i >> 2))[i & 3]);
}
#else
// Entries, two in a word, the first in its lower half.
layout(std140) uniform ew_lists
{
    uvec4 ew_list_words[EW_LIST_SIZE];
};

int ew_list_entry(const int i)
{
    uint word = ew_list_words[i >> 3][(i >> 1) & 3];
    return int((i & 1) == 0 ? word & 0xffffu : word >> 16);
}
#endif

// Where a tile's row of list `list` is, from its first; of EW_LIST_COUNT, where the next tile's first row is. Lists that are empty all over
// the frame have none, and end where they begin.
int ew_list_row(const int list)
{
#ifdef EW_VERTEX_STAGE // what it hands on it cannot read
    return ew_uniform_list_rows[list >> 2][list & 3];
#else
    return ew_list_rows[list >> 2][list & 3];
#endif
}

// The first row, in the table of lists, of the tile at a pixel of the grid's viewport, or of the nodes around it.
int ew_find_tile_row(const ivec2 pixel)
{
    ivec2 tile = (pixel - ew_grid.tiles.zw) >> ew_grid.tiles.y;
    return (tile.y * ew_grid.tiles.x + tile.x) * ew_list_row(EW_LIST_COUNT);
}

// Whether the lists from `first` up to `end` are empty in the tile of a row.
bool ew_are_lists_empty(const int tile_row, const int first, const int end)
{
    return ew_list_entry(tile_row + ew_list_row(first)) == ew_list_entry(tile_row + ew_list_row(end));
}

// What ew_find_tile_row says of the fragment. It is the same for a whole patch.
#ifndef EW_PATCHES
int ew_tile_row = 0;
#elif defined(EW_VERTEX_STAGE)
flat out int ew_tile_row;
#else
flat in int ew_tile_row;
#endif
