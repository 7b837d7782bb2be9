/*
 * What was found about random scenes, for people.
 */
#ifndef RANDOM_REPORT_H
#define RANDOM_REPORT_H

#include "random_picture.h"

/* Prints a table of the kinds of scenes and the `worst` scenes, worst first, of complete pictures. `well` becomes true if no
 * pixel is bad, the reference vouches for 99 % of them and, if `check`, the bounds are kept. Returns false where memory is
 * exhausted. */
bool random_report_print(const random_picture *pictures, size_t count, size_t worst, bool check, bool *well);

#endif
