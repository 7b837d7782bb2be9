/*
 * What the comparison of a picture with the reference found, in words and in a table.
 */
#ifndef ACCURACY_RESULT_H
#define ACCURACY_RESULT_H

#include "comparison.h"
#include "named_integrator.h"

typedef struct accuracy_result {
    const char *path; /* of the scene */
    const char *renderer;
    const named_integrator *integrator;
    const drawn_picture *picture;
    const true_pixels *truth;
    picture_comparison comparison;
} accuracy_result;

/* How far beyond its integrator's bounds the picture is, as a factor; without bounds, its error. */
double accuracy_excess(const accuracy_result *result);

/* Writes one line for people, without its end. */
void accuracy_describe(const accuracy_result *result, char *text, size_t size);

/* Appends a line to a table, whose first line says what is in it. Returns false if it cannot be written. */
bool accuracy_append_csv(const accuracy_result *result, const char *path);

#endif
