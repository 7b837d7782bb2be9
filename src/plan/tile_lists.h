/*
 * Which sources may light which tiles of a viewport. Tiles are squares, and go on beyond the viewport as far as the nodes of
 * adaptive resolution do.
 *
 * The entries are what the shader reads (glsl/light/list.glsl). First comes a table with EW_KIND_COUNT rows a tile, tile after
 * tile: where the list of the tile's sources of each kind begins. It ends where the next row's begins; the table has one row
 * more. Then come the lists: the sources' places in their kinds.
 */
#ifndef EW_TILE_LISTS_H
#define EW_TILE_LISTS_H

#include "base/allocator.h"
#include "model/rays.h"
#include "model/sources.h"

#include <stdint.h>

/* A row of the table, and a source of its list. */
struct ew_tile_pair {
    uint32_t row, place;
};

/* Starts as {0}, and keeps its memory from frame to frame. */
typedef struct ew_tile_lists {
    uint32_t *entries;
    size_t entry_count, entry_capacity;
    int columns, rows;
    int size_log2; /* of a tile's width in pixels */

    /* While the lists are made: what was found, and for each row, which source was the last. */
    struct ew_tile_pair *pairs;
    size_t pair_count, pair_capacity;
    uint32_t *last_sources;
    size_t last_source_capacity;
} ew_tile_lists;

/* The most entries: tiles are made wider until there are no more. */
#define EW_MAX_LIST_ENTRIES (1 << 20)

/* Makes the lists for the sources as they are seen between two depths. On failure nothing may be drawn with them. */
ew_result ew_make_tile_lists(ew_tile_lists *lists, const ew_sources *sources, const ew_view *view, const ew_interval *depths,
                             const ew_viewport *viewport, const ew_allocator *allocator, ew_error *error);

void ew_destroy_tile_lists(ew_tile_lists *lists, const ew_allocator *allocator);

#endif
