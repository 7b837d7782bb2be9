/*
 * The host's sources: checked, kept in double precision, and packed for a frame into the shader's uniform block.
 */
#ifndef EW_SOURCES_H
#define EW_SOURCES_H

#include "model/kinds.h"

#include <stdbool.h>

/* Starts as {0}. All arrays lie in one allocation; the blocks of all kinds, the weight pieces and the pieces of paths lie
 * one after the other, as in the uniform block. */
typedef struct ew_sources {
    void *memory;
    size_t memory_size;
    double epsilon;
    bool has_glow; /* the blocks have their last member */
    size_t counts[EW_KIND_COUNT];
    void *lists[EW_KIND_COUNT];   /* copies of the host's */
    ew_ball *balls;               /* one for each source, kind after kind */
    ew_piece_range *piece_ranges; /* one for each source that is a chain, kind after kind */
    void *pieces;                 /* in world space */
    bool has_joints, has_bends;   /* a path has bent pieces */
    ew_weight_range *weights;     /* one for each source of a kind that has weights, kind after kind */
    void *data;                   /* what goes into the uniform block */
    size_t data_size;
    size_t weight_piece_count;
    size_t weight_units; /* where they begin, in units */
} ew_sources;

/* How many units (vec4) of sources a uniform block of `block_size` bytes holds. */
size_t ew_sources_capacity(size_t block_size);

/* Replaces what `sources` holds by a copy of `desc`, in the same memory if it is large enough. On failure `sources` is left
 * alone. */
ew_result ew_sources_set(ew_sources *sources, const ew_sources_desc *desc, size_t capacity, const ew_allocator *allocator,
                         ew_error *error);

void ew_sources_destroy(ew_sources *sources, const ew_allocator *allocator);

/* What the sources are. */
ew_mix ew_sources_mix(const ew_sources *sources);

/* How a frame's integral wants sources. */
typedef struct ew_packing {
    ew_ray_space space;
    double coefficient_scale; /* on all coefficients */
    double exposure;          /* on all colours */
    bool needs_reach;         /* refuses a source without a reach */
} ew_packing;

/* Brings the sources to ray space and fills `data`. */
ew_result ew_sources_pack(ew_sources *sources, const ew_packing *packing, ew_error *error);

/* Calls `take` with a ball around all that each source can light, and its reach: HUGE_VAL is the radius of what has no end. */
void ew_sources_for_each_lit_ball(const ew_sources *sources, void (*take)(void *user, const ew_ball *ball, double reach),
                                  void *user);

#endif
