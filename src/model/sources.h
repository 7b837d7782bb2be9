/*
 * The host's sources: checked, kept in double precision, and packed for a frame into the shader's uniform block.
 */
#ifndef EW_SOURCES_H
#define EW_SOURCES_H

#include "model/kinds.h"

#include <stdbool.h>

/* A source, and how far it lights. */
typedef struct ew_lit_source {
    const ew_kind *kind;
    const void *source;           /* the copy of the host's */
    size_t index;                 /* in its list */
    const ew_piece_range *pieces; /* NULL for a kind that is no chain */
    ew_ball ball;                 /* around the source */
    double reach;                 /* 0: without end */
} ew_lit_source;

/* Its light is within reach of one of its hulls. */
size_t ew_count_hulls(const ew_lit_source *lit);
ew_hull ew_hull_of_source(const ew_lit_source *lit, size_t index);

/* Starts as {0}. All arrays lie in one allocation; the blocks of all kinds, the weight pieces and the pieces of paths lie
 * one after the other, as in the uniform block. */
typedef struct ew_sources {
    void *memory;
    size_t memory_size;
    double epsilon;
    bool has_glow; /* the blocks have their last member */
    bool has_sharpness;
    size_t counts[EW_KIND_COUNT];
    void *lists[EW_KIND_COUNT]; /* copies of the host's */
    ew_lit_source *lit;         /* all sources, kind after kind */
    size_t lit_count;
    ew_piece_range *piece_ranges; /* one for each source that is a chain, kind after kind */
    void *pieces;                 /* in world space */
    bool has_list[EW_LIST_COUNT]; /* there are sources that go into such lists */
    ew_weight_range *weights;     /* one for each source of a kind that has weights, kind after kind */
    void *data;                   /* what goes into the uniform block */
    size_t data_size;
    size_t weight_piece_count;
    size_t weight_units; /* where they begin, in units */
} ew_sources;

/* The list of a tile into which it goes. */
ew_list ew_list_of(const ew_lit_source *lit);

/* Source i, kind after kind. A `light_reach` > 0 is how far it lights surfaces, in the place of its own reach; 0 stands for
 * that. */
static inline ew_lit_source ew_lit_source_at(const ew_sources *sources, size_t i, double light_reach)
{
    ew_lit_source lit = sources->lit[i];
    if (light_reach > 0) lit.reach = light_reach;
    return lit;
}

/* The size of the largest block that is used where GL takes blocks of `block_size` bytes. */
size_t ew_largest_block(size_t block_size);

/* How many units (vec4) of sources a uniform block of `block_size` bytes holds. */
size_t ew_sources_capacity(size_t block_size);

/* Replaces what `sources` holds by a copy of `desc`, in the same memory if it is large enough. On failure `sources` is left
 * alone. */
ew_result ew_sources_set(ew_sources *sources, const ew_sources_desc *desc, const ew_allocator *allocator, ew_error *error);

void ew_sources_destroy(ew_sources *sources, const ew_allocator *allocator);

/* What the sources are. */
ew_mix ew_sources_mix(const ew_sources *sources);

/* How a frame's integral wants sources. */
typedef struct ew_packing {
    ew_ray_space space;
    double coefficient_scale; /* on all coefficients */
    double exposure;          /* on all colours */
    double least_core;        /* that is allowed, in ray space */
} ew_packing;

/* Brings the sources to ray space and fills `data`. */
ew_result ew_sources_pack(ew_sources *sources, const ew_packing *packing, ew_error *error);

/* Refuses a source without a reach. */
ew_result ew_sources_check_reach(const ew_sources *sources, ew_error *error);

#endif
