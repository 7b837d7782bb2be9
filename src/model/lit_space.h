/* The space in which the world integral is computed: what a host's interval is to the papers', its sources decide. */
#ifndef EW_LIT_SPACE_H
#define EW_LIT_SPACE_H

#include "model/rays.h"
#include "model/sources.h"

typedef struct ew_lit_space {
    /* The view depths between which sources can light anything, from the eye on, or from the near plane of a parallel
     * projection. Never empty. */
    ew_interval interval;
    /* A length in which what is computed with is neither large nor small: how far away the sources are, their reaches left
     * out. */
    double unit;
} ew_lit_space;

/* Where a source has no end, the interval ends where its core, which grows by `core_growth` a unit of depth, is as wide as its
 * reach, or far away. `light_reach`: see ew_lit_source_at. */
ew_lit_space ew_find_lit_space(const ew_sources *sources, double light_reach, const ew_view *view, double core_growth);

#endif
