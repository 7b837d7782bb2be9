/* The sources and the frame, without GL: validated, kept in double precision, and packed into the shader's uniform blocks. */
#ifndef EW_SCENE_H
#define EW_SCENE_H

#include "energywave.h"
#include "layout.h"

/* How many sources of each kind the context's uniform blocks hold. */
typedef struct ew_capacity {
    size_t points;
    size_t lines;
    size_t tori;
    size_t curves;
    size_t weight_pieces;
} ew_capacity;

/* The host's sources and, beside them, room for the uniform blocks that a frame makes of them; each block array is as long as
 * the list it is made of. */
typedef struct ew_scene {
    void *memory; /* all arrays below */
    ew_sources_desc sources;
    struct ew_point_block *points;
    struct ew_line_block *lines;
    struct ew_torus_block *tori;
    struct ew_curve_block *curves;
    struct ew_weight_block *weight_pieces;
    size_t weight_piece_count;
} ew_scene;

/* The capacity of uniform blocks of `block_size` bytes each. */
ew_capacity ew_scene_capacity(size_t block_size);

/* Makes a scene of a copy of `sources`. On failure `scene` is left alone. */
ew_result ew_scene_create(const ew_sources_desc *sources, const ew_capacity *capacity, ew_scene *scene, ew_error *error);

void ew_scene_destroy(ew_scene *scene);

/* Checks what can be checked of a frame without GL. */
ew_result ew_validate_frame(const ew_frame_desc *frame, ew_error *error);

/* Brings the scene into the ray space of a valid `frame`, in double precision until the last step, and fills the scene's
 * blocks and `block`. */
ew_result ew_scene_pack(ew_scene *scene, const ew_frame_desc *frame, struct ew_frame_block *block, ew_error *error);

#endif
