/*
 * What was found about random scenes, for people.
 */
#ifndef RANDOM_REPORT_H
#define RANDOM_REPORT_H

#include "random_picture.h"

/* What every kind of scenes is held to: the error of every pixel, and the share of the pixels that may be beyond 1e-3. */
typedef struct random_bounds {
    double largest, unusual_share;
} random_bounds;

/* Prints a table of the kinds of scenes and the `worst` scenes, worst first, of complete pictures. `well` becomes true if no
 * pixel is bad, the reference vouches for 99 % of them and the bounds, unless NULL, are kept. Returns false where memory is
 * exhausted. */
bool random_report_print(const random_picture *pictures, size_t count, size_t worst, const random_bounds *bounds, bool *well);

#endif
