/*
 * Maps of the method in false colours: how often the rays were evaluated, and how far off they are.
 */
#ifndef MAP_H
#define MAP_H

#include "energywave.h"
#include "gl_functions.h"

#include <stdbool.h>

/* The reference is EW_INTEGRATOR_SIMPSON, which shares no formula with the adaptive integrator, on MAP_REFERENCE_PARTS parts of
 * the interval with the most divisions that it takes. Steps longer than epsilon blur the cores; so its own error shows there.
 */
enum { MAP_REFERENCE_PARTS = 4, MAP_REFERENCE_DIVISIONS = MAP_REFERENCE_PARTS * EW_MAX_SIMPSON_DIVISIONS };

typedef struct map_statistics {
    double mean_evaluations;
    double largest_error; /* relative, and below: negative in a map of evaluations */
    double error_of_99_percent;
} map_statistics;

/* Each takes a frame whose framebuffer has one 32-bit float channel; its output does not count. */

/* The mean number of evaluations of its pixels. */
ew_result map_count_evaluations(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, double *mean,
                                ew_error *error);

/* Draws the frame's evaluations, or its errors, and writes their colours into `picture`, an 8-bit texture, at the same place.
 */
ew_result map_draw(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, bool is_error, GLuint picture,
                   map_statistics *statistics, ew_error *error);

#endif
