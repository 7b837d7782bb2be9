/*
 * The nearest point of an arc: of all stationary points of the distance and the two ends.
 */
#ifndef REFERENCE_ARC_H
#define REFERENCE_ARC_H

#include "energywave.h"
#include "reference_source.h"

/* `from` is C0 minus the point that is asked about. */
nearest_point reference_nearest_of_arc(const ew_curve *curve, const double from[3]);

/* The distance from a point to a curve, and in `t` (NULL for none) the nearest parameter. */
double reference_curve_distance(const ew_curve *curve, const double point[3], double *t);

#endif
