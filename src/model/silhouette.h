/* Where light is seen that reaches as far as a radius around a hull. */
#ifndef EW_SILHOUETTE_H
#define EW_SILHOUETTE_H

#include "model/kinds.h"
#include "model/rays.h"

/* A box of NDC in x and y, and view depths. */
typedef struct ew_silhouette {
    double low[2], high[2];
    ew_interval depths;
} ew_silhouette;

/* Finds what is seen of all within `radius` of a hull that ew_see_hull returned, and between `depths`, in the viewport, whose
 * NDC run from -1 to 1. A polygon's box is as small as can be on each axis alone; a line's, with regard to what the viewport
 * cuts off. Returns false if nothing is seen. */
bool ew_find_silhouette(const ew_hull *seen, double radius, const ew_view *view, const ew_interval *depths,
                        ew_silhouette *silhouette);

#endif
