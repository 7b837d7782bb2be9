/* What sources can light of a view. */
#ifndef EW_MODEL_BOUNDS_H
#define EW_MODEL_BOUNDS_H

#include "model/media.h"
#include "model/rays.h"
#include "model/sources.h"

/* The rectangle of pixels that one source can light between `depths`, and where between them: see ew_get_bounds. */
ew_bounds ew_find_source_bounds(const ew_lit_source *lit, const ew_view *view, const ew_interval *depths,
                                const ew_viewport *viewport);

/* The same of all sources. `light_reach`: see ew_lit_source_at. */
ew_bounds ew_find_bounds(const ew_sources *sources, double light_reach, const ew_view *view, const ew_interval *depths,
                         const ew_viewport *viewport);

/* The rectangle and the depths in which media are seen. */
ew_bounds ew_find_media_bounds(const ew_medium *media, size_t count, const ew_view *view, const ew_viewport *viewport);

/* What is in either of two bounds. */
ew_bounds ew_unite_bounds(const ew_bounds *a, const ew_bounds *b);

#endif
