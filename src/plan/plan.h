/*
 * A plan: a frame and its sources, resolved once into what is to be drawn and how. It needs no GL; the host layer executes it.
 */
#ifndef EW_PLAN_H
#define EW_PLAN_H

#include "model/rays.h"
#include "model/sources.h"
#include "plan/permutation.h"
#include "plan/shader_text.h"
#include "plan/tile_lists.h"

/* What becomes of the shader's colour and the target's: see ew_output. */
typedef enum ew_blend {
    EW_BLEND_REPLACE,
    EW_BLEND_OVER,  /* premultiplied */
    EW_BLEND_DIM,   /* the same, but alpha is left alone */
    EW_BLEND_ADD,   /* likewise */
    EW_BLEND_SOFT,  /* the target pales by the colour; likewise */
    EW_BLEND_LIGHT, /* the target is the albedo of what the colour lights; likewise */
} ew_blend;

/* Where and how to draw. */
typedef struct ew_target {
    unsigned framebuffer;
    ew_viewport viewport;
    ew_blend blend;
    bool encodes_srgb;
    bool keeps_stencil_test; /* the host's */
} ew_target;

/* Where the opaque scene's depth comes from. */
typedef struct ew_depth_request {
    ew_depth_source source;
    unsigned texture; /* of the sources that are textures; 0: nothing is opaque */
} ew_depth_request;

typedef struct ew_plan {
    ew_pass pass;       /* that draws it where there is no grid */
    ew_key permutation; /* without depth, whose kind the context must tell */
    struct ew_uniform_head uniforms;
    const void *source_data; /* behind the uniforms' head; the sources' own */
    size_t source_data_size;
    size_t source_units;        /* that the shader must take */
    const ew_tile_lists *lists; /* NULL for a shader that has none */
    ew_interval depths;         /* between which the sources are seen */
    ew_target target;
    ew_depth_request depth;
    ew_viewport lit;         /* what of the target's viewport is drawn: all that the sources can light */
    bool is_adaptive;        /* in resolution */
    double light_reach;      /* of a plan that draws surfaces; else 0 */
    unsigned normal_texture; /* of these; 0: normals are found from depth */
    bool skips_restore;
} ew_plan;

/* In a texture, the sources' units come first, row by row, and the lists begin in the next row. */
static inline int ew_first_list_row(const ew_plan *plan)
{
    return (int)((plan->source_data_size / sizeof(ew_vec4) + EW_TEXTURE_WIDTH - 1) / EW_TEXTURE_WIDTH);
}

/* Plans the uniforms alone, of a frame that has a view and needs no target. */
ew_result ew_plan_uniforms(ew_plan *plan, ew_sources *sources, const ew_frame_desc *frame, ew_error *error);

/* Plans the drawing of `sources` as `frame` says, with the shader for `mix`; NULL: for the sources. The plan is valid until the
 * sources change or are planned again. */
ew_result ew_plan_frame(ew_plan *plan, ew_sources *sources, const ew_mix *mix, const ew_frame_desc *frame, ew_error *error);

/* Plans the drawing of the media themselves, of a frame that ew_plan_frame has taken. `draws` receives whether
 * there are any to be drawn. */
ew_result ew_plan_media(ew_plan *plan, const ew_frame_desc *frame, bool *draws, ew_error *error);

/* Completes a plan of ew_plan_frame by lists of the sources by tile, if the sources have reaches.
 * The plan is valid until the lists are made again. */
ew_result ew_plan_lists(ew_plan *plan, ew_tile_lists *lists, const ew_sources *sources, const ew_frame_desc *frame,
                        ew_list_room room, const ew_allocator *allocator, ew_error *error);

/* Says what the sources can light of a frame: see ew_get_bounds. */
ew_result ew_plan_bounds(const ew_sources *sources, const ew_frame_desc *frame, ew_bounds *bounds, ew_error *error);

#endif
