/*
 * A path's field by brute force: by the formulas of quadratic B-splines and of segments, rather than of Bezier curves.
 */
#ifndef BRUTE_FORCE_PATH_H
#define BRUTE_FORCE_PATH_H

#include "brute_force.h"

/* The field at p of a polyline or a quadratic B-spline, for a coefficient of 1. */
long double brute_force_path_field(const ew_path *path, const brute_force_light *light, const long double p[3]);

#endif
