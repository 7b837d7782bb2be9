/*
 * The weight along a curve: the clamped uniform quadratic B-spline by its recursive definition.
 */
#ifndef REFERENCE_WEIGHT_H
#define REFERENCE_WEIGHT_H

#include <stddef.h>

/* The weight at u in [0, 1] of a list of `count` values: 1 for none, a constant for one, a ramp for two, else the B-spline of
 * equations (14) to (16), with half-open intervals but for the last. */
double reference_weight(const double *weights, size_t count, double u);

/* The polynomial piece that u is on. Only the three basis functions from this one on differ from 0 there. */
int reference_weight_span(size_t count, double u);

#endif
