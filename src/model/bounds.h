/* What sources can light of a view: the interval of the world integral, and bounds for the host. */
#ifndef EW_MODEL_BOUNDS_H
#define EW_MODEL_BOUNDS_H

#include "model/rays.h"
#include "model/sources.h"

/* The view depths between which sources can light anything, from the eye on, or from the near plane of a parallel projection.
 * Where one has no end, the interval ends where its core, which grows by `core_growth` a unit of depth, is as wide as its
 * reach, or far away. Never empty, so that it can be a unit of length. */
ew_interval ew_lit_interval(const ew_sources *sources, const ew_view *view, double core_growth);

/* A length in which what the world integral computes with is neither large nor small: how far away the sources are, their
 * reaches left out. */
double ew_lit_scale(const ew_sources *sources, const ew_view *view);

/* See ew_get_bounds. `interval` bounds the sources that have no reach; NULL in the world integral. */
ew_bounds ew_find_bounds(const ew_sources *sources, const ew_view *view, const ew_interval *interval,
                         const ew_viewport *viewport);

#endif
