/* What sources can light of a view. */
#ifndef EW_MODEL_BOUNDS_H
#define EW_MODEL_BOUNDS_H

#include "model/rays.h"
#include "model/sources.h"

/* The rectangle of pixels that one source can light between `depths`, and where between them: see ew_get_bounds. */
ew_bounds ew_find_source_bounds(const ew_lit_source *lit, const ew_view *view, const ew_interval *depths,
                                const ew_viewport *viewport);

/* The same of all sources. `light_reach`: see ew_lit_source_at. */
ew_bounds ew_find_bounds(const ew_sources *sources, double light_reach, const ew_view *view, const ew_interval *depths,
                         const ew_viewport *viewport);

#endif
