/*
 * Luminances by brute force in extended precision, for the reference to be compared with: dense quadrature that knows nothing
 * of the integrand, and distances and weights by other formulas than the reference's.
 */
#ifndef BRUTE_FORCE_H
#define BRUTE_FORCE_H

#include "energywave.h"
#include "reference.h"

/* The relative error of brute_force_luminance. */
#define BRUTE_FORCE_ERROR 1e-8

/* The luminance of a single source. */
double brute_force_luminance(const ew_sources_desc *sources, const reference_ray *ray);

/* The distance to the nearest of 33 points of the arc, of that one polished by Newton's method, and of the roots of the cubic
 * (12) by Cardano's formula, polished too. */
long double brute_force_curve_distance(const ew_curve *curve, const long double p[3], long double *nearest_t);

long double brute_force_square_distance_at(const ew_curve *curve, const long double p[3], long double t);

#endif
