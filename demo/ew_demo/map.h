/*
 * Maps in false colours: how often each pixel's ray was evaluated, and how large its error is.
 */
#ifndef MAP_H
#define MAP_H

#include "energywave.h"
#include "gl_functions.h"

#include <stdbool.h>

/* The reference is Simpson's rule, which shares no formula with the adaptive integrator, with EW_MAX_SIMPSON_DIVISIONS on each
 * of MAP_REFERENCE_PARTS parts of the interval; in the world integral, on what the reaches leave of the ray. Where a division
 * is longer than a core's radius, the reference's own error shows. Light is made sharp after it has been
 * integrated, so over the parts of an interval, sources with a sharpness above 1 seem to have errors that they do not have.
 * Mesa's software rasteriser ends a pixel's loops after 65535 steps, so there the reference is wrong where a ray meets more
 * than 15 pieces of paths. */
enum { MAP_REFERENCE_PARTS = 4, MAP_REFERENCE_DIVISIONS = MAP_REFERENCE_PARTS * EW_MAX_SIMPSON_DIVISIONS };

typedef struct map_statistics {
    double mean_evaluations;
    double largest_error;       /* relative; negative in a map of evaluations */
    double error_of_99_percent; /* 99 % of the pixels have at most this; likewise */
} map_statistics;

/* The frame of both functions has a framebuffer with one 32-bit float channel. Its `output` is ignored. */

/* Sets *mean to the mean number of evaluations of the frame's pixels. */
ew_result map_count_evaluations(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, double *mean,
                                ew_error *error);

/* Maps the frame's evaluations or errors to colours, in the same rectangle of `picture`, an 8-bit texture. */
ew_result map_draw(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, bool is_error, GLuint picture,
                   map_statistics *statistics, ew_error *error);

#endif
