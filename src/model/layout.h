/* The uniform block as C sees it, with the structures of glsl/base/layout.glsl. */
#ifndef EW_LAYOUT_H
#define EW_LAYOUT_H

typedef struct ew_vec4 {
    float x, y, z, w;
} ew_vec4;

typedef struct ew_ivec4 {
    int x, y, z, w;
} ew_ivec4;

#define vec4 ew_vec4
#define ivec4 ew_ivec4
#include "../../glsl/base/layout.glsl"
#undef vec4
#undef ivec4

/* What comes before the sources: see glsl/base/blocks.glsl. */
struct ew_uniform_head {
    struct ew_frame_block frame;
    int source_counts[4 * EW_COUNT_VECTORS]; /* by kind */
    int list_rows[4 * EW_LIST_VECTORS];      /* see struct ew_tile_lists */
    struct ew_grid_block grid;
    struct ew_fog_block fog;
    struct ew_medium_block media[EW_MEDIUM_ROOM];
};

#endif
