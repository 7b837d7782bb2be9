/*
 * Which sources may light which tiles of a viewport. Tiles are squares, and go on beyond the viewport as far as the nodes of
 * adaptive resolution do.
 *
 * The entries are what the shader reads (glsl/light/list.glsl). First comes a table, tile after tile, with a row for each
 * ew_list that any source of the frame goes into: where the list of the tile's sources begins. It ends where the next row's
 * begins; the table has one row more. Then come the lists: the sources' places in their kinds. If any path of the frame has
 * pieces, behind the place of every path stands which of its pieces light the tile: the first one, and 256 times the last, in
 * steps of as many pieces as let both be less than 256. For a uniform block, entries are 16 bits wide, two in a word; for a
 * texture, each is a float.
 */
#ifndef EW_TILE_LISTS_H
#define EW_TILE_LISTS_H

#include "base/allocator.h"
#include "model/rays.h"
#include "model/sources.h"

#include <stdbool.h>
#include <stdint.h>

/* Where lists go: how many entries they may have there, and whether these are floats. */
typedef struct ew_list_room {
    size_t most;
    bool is_texture;
} ew_list_room;

/* The room in a uniform block of so many units (vec4), and in a texture. */
ew_list_room ew_list_room_of_block(size_t units);
ew_list_room ew_list_room_of_texture(void);

/* A row of the table, and a source of its list; of one with a second entry, in those steps, which pieces light the tile. */
struct ew_tile_pair {
    uint32_t row, place;
    bool has_range;
    uint8_t first_piece, last_piece;
};

/* Starts as {0}, and keeps its memory from frame to frame. */
typedef struct ew_tile_lists {
    uint32_t *words;
    size_t entry_count, word_count, word_capacity;
    ew_list_room room;
    int columns, rows;
    int size_log2;                    /* of a tile's width in pixels */
    int path_entries;                 /* how many entries a path takes in a list */
    int list_rows[EW_LIST_COUNT + 1]; /* of a tile: where each list's row is, and last, how many rows there are */
    ew_viewport lit;                  /* the part of the viewport around all tiles that are lit; at least a pixel */
    int first_x, first_y;             /* pixel where the first tile begins */

    /* While the lists are made: what was found, and for each row, which pair was the last, from 1 on. */
    struct ew_tile_pair *pairs;
    size_t pair_count, pair_capacity;
    uint32_t *last_pairs;
    size_t last_pair_capacity;
} ew_tile_lists;

/* Makes the lists for the sources as they are seen between two depths. Tiles are made wider until there are at most `most`
 * entries. On failure nothing may be drawn with the lists. Where even a tile for all takes more, entry_count is 0.
 * `light_reach`: see ew_lit_source_at. */
ew_result ew_make_tile_lists(ew_tile_lists *lists, const ew_sources *sources, double light_reach, const ew_view *view,
                             const ew_interval *depths, const ew_viewport *viewport, ew_list_room room,
                             const ew_allocator *allocator, ew_error *error);

void ew_destroy_tile_lists(ew_tile_lists *lists, const ew_allocator *allocator);

#endif
