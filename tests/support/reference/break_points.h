/*
 * Where to divide a ray so that on each part the integrand of a source is smooth.
 *
 * It has peaks as narrow as the core (closest approaches), kinks (the nearest point enters or leaves an end of the arc, or a
 * knot; the ray enters or leaves the core or the reach) and jumps (the nearest point leaps between the branches of a weighted
 * curve). All are looked for by sampling along the ray and narrowed down by bisection, and become break points, with further
 * ones in geometric progression around every peak. What the search misses, the error estimates of the quadrature see.
 */
#ifndef BREAK_POINTS_H
#define BREAK_POINTS_H

#include "integrand.h"

#include <gsl/gsl_roots.h>

/* Behind so many optical depths of fog, no light is looked for. */
#define REFERENCE_FOG_DEPTH 100

enum { MAX_SAMPLES = 4096, MAX_PEAKS = 16, MAX_BREAK_POINTS = 2048 };

/* Beyond its limits, samples and break points are dropped: that costs the quadrature time and maybe its error bound, which it
 * tells. */
typedef struct break_point_search {
    gsl_root_fsolver *solver; /* the caller's */
    integrand_sample samples[MAX_SAMPLES];
    size_t sample_count;
    double peaks[MAX_PEAKS];
    size_t peak_count;
    double break_points[MAX_BREAK_POINTS];
    size_t break_point_count;
} break_point_search;

/* Fills the search's break points on the part of the ray that begins at the integrand's origin and is `end` > 0 long in s, its
 * ends among them, sorted. Moves the origin to the narrowest peak and measures the break points from there. There are none
 * where all of the part is beyond the source's reach. */
void break_points_find(break_point_search *search, integrand *f, double end);

#endif
