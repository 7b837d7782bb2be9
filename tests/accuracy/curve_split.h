/*
 * A curve split at a point of the arc gives the same light as the whole.
 */
#ifndef CURVE_SPLIT_H
#define CURVE_SPLIT_H

#include "equation.h"

/* Compares the stage's curve number `index` with its two parts. `ramp` are the two weights that it gets instead of its own,
 * NULL for none. On failure says why and returns false. */
bool curve_splits(equation_stage *s, size_t index, const double ramp[2]);

#endif
