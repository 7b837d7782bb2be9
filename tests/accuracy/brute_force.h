/*
 * Luminances by brute force in extended precision, for the reference to be compared with: dense quadrature that knows nothing
 * of the integrand, and distances and weights by other formulas than the reference's.
 */
#ifndef BRUTE_FORCE_H
#define BRUTE_FORCE_H

#include "energywave.h"
#include "reference.h"

/* The error of brute_force_luminance, relative to it and, where next to nothing of the ray is lit, to the coefficient. */
#define BRUTE_FORCE_ERROR 1e-8
#define BRUTE_FORCE_DARK_ERROR 1e-10

/* The luminance of a single source, before its sharpness. */
double brute_force_luminance(const ew_sources_desc *sources, const reference_ray *ray);

/* The distance to the nearest of 33 points of the arc, of that one polished by Newton's method, and of the roots of the cubic
 * (12) by Cardano's formula, polished too. */
long double brute_force_curve_distance(const ew_curve *curve, const long double p[3], long double *nearest_t);

/* The weight at u in [0, 1] of a list, by de Boor's algorithm. */
long double brute_force_weight(const double *weights, size_t count, long double u);

/* A source's light at a place on a ray: its core is at least as wide as pixels there. No reach is 0. */
typedef struct brute_force_light {
    long double coefficient, core, reach;
} brute_force_light;

/* The field at a distance, for a coefficient and a weight of 1. */
long double brute_force_glow(const brute_force_light *light, long double distance);

long double brute_force_square_distance_at(const ew_curve *curve, const long double p[3], long double t);

#endif
