/* A bundle of rays, and whether it meets what a source can light. */
#ifndef EW_CONE_H
#define EW_CONE_H

#include "model/kinds.h"
#include "model/rays.h"

/* A cone in view space, where the third coordinate is depth. At each depth its axis is at origin + depth slope, and its rays
 * are within width + depth growth of that. */
typedef struct ew_cone {
    double origin[2], slope[2];
    double width, growth;
    ew_interval depths;
} ew_cone;

/* The rays of all of a view, which are linear in NDC. */
typedef struct ew_ray_field {
    ew_cone axis; /* through NDC (0, 0), without a width */
    /* How origin and slope change with x and with y of NDC. */
    double origin_growth[2][2], slope_growth[2][2];
} ew_ray_field;

ew_ray_field ew_make_ray_field(const ew_view *view, const ew_interval *depths);

/* The cone around the rays through a box of NDC. */
ew_cone ew_cone_of(const ew_ray_field *field, const double low[2], const double high[2]);

/* Whether some ray of the cone comes within `radius` of a hull that ew_see_hull returned. May say yes where rays pass close by.
 */
bool ew_cone_meets(const ew_cone *cone, const ew_hull *seen, double radius);

/* Whether all rays of the cone do so. May say no where they do. */
bool ew_cone_is_covered(const ew_cone *cone, const ew_hull *seen, double radius);

#endif
