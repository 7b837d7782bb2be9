/*
 * Paths that are written in another way give the same light.
 */
#ifndef PATH_FORMS_H
#define PATH_FORMS_H

#include "equation.h"

/* Compares all paths with the same ones from their ends to their starts, weights and all. On failure returns false. */
bool paths_reverse(equation_stage *s, const luminance_sum *whole);

/* Compares open B-splines with the Bezier chains that they are. On failure returns false. */
bool splines_are_beziers(equation_stage *s, const luminance_sum *whole);

#endif
