/* Cubic Bezier curves, and the quadratic pieces that stand for them. */
#ifndef EW_SPLINE_H
#define EW_SPLINE_H

#include <stdbool.h>

typedef struct ew_cubic {
    double points[4][3];
} ew_cubic;

/* C(u) = polynomial[0] + u polynomial[1] + u^2 polynomial[2] with u in [0, 1]. */
typedef struct ew_quadratic {
    double polynomial[3][3];
} ew_quadratic;

/* The quadratic that begins at `start`, spans `chord` and whose control point is half of `bend` before the chord's middle. */
ew_quadratic ew_quadratic_from_chord(const double start[3], const double chord[3], const double bend[3]);

/* In how many equal parts the cubic must be cut so that each ew_cubic_part stays within `tolerance` of it at the same
 * parameter. A whole number >= 1; infinite or NaN for coordinates near the largest double. */
double ew_cubic_part_count(const ew_cubic *cubic, double tolerance);

/* The quadratic for the part of the cubic from `start` to `end` in its parameter. It meets the cubic at both ends. */
ew_quadratic ew_cubic_part(const ew_cubic *cubic, double start, double end);

/* Whether the quadratic runs along its chord without turning back, and nowhere leaves it by more than `tolerance`. */
bool ew_quadratic_is_straight(const ew_quadratic *quadratic, double tolerance);

/* Whether the quadratic stays within `tolerance` of its start. */
bool ew_quadratic_is_point(const ew_quadratic *quadratic, double tolerance);

#endif
