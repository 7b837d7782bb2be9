/* The sources and the frame, without GL: validated, kept in double precision, and packed into the shader's uniform block. */
#ifndef EW_SCENE_H
#define EW_SCENE_H

#include "energywave.h"
#include "model/layout.h"

/* The host's sources and, beside them, room for what a frame makes of them for the uniform block: the arrays from `points` to
 * `weight_pieces` lie one after the other, as in ew_source_data, each as long as the list it is made of. */
typedef struct ew_scene {
    void *memory; /* all arrays below */
    size_t memory_size;
    ew_sources_desc sources;
    void *source_data;
    size_t source_data_size; /* in bytes */
    struct ew_point_block *points;
    struct ew_line_block *lines;
    struct ew_torus_block *tori;
    struct ew_curve_block *curves;
    struct ew_weight_block *weight_pieces;
    size_t weight_piece_count;
} ew_scene;

/* How many units (vec4) of sources a uniform block of `block_size` bytes holds beside the frame. */
size_t ew_scene_capacity(size_t block_size);

/* Replaces what the scene (all zero, or set before) holds by a copy of `sources`, in the same memory if it is large enough. On
 * failure the scene is left alone. */
ew_result ew_scene_set(ew_scene *scene, const ew_sources_desc *sources, size_t capacity, const ew_allocator *allocator,
                       ew_error *error);

/* What the scene's sources are. */
ew_mix ew_scene_mix(const ew_scene *scene);

void ew_scene_destroy(ew_scene *scene, const ew_allocator *allocator);

/* Checks what can be checked of a frame without GL. */
ew_result ew_validate_frame(const ew_frame_desc *frame, ew_error *error);

/* Brings the scene into the ray space of a valid `frame`, in double precision until the last step, and fills the scene's
 * blocks and `block`. */
ew_result ew_scene_pack(ew_scene *scene, const ew_frame_desc *frame, struct ew_frame_block *block, ew_error *error);

#endif
