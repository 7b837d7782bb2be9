/*
 * Speed and error of integrators on a scene.
 */
#ifndef MEASURE_H
#define MEASURE_H

#include "context.h"
#include "integrator.h"
#include "scene_file.h"

/* The fewest repetitions of any frame, and the milliseconds after which an integrator is not repeated more often than that. */
#define MEASURE_MIN_REPETITIONS 3
#define MEASURE_BUDGET 1500.0

typedef struct measure_settings {
    int width;
    int height;
    const bench_integrator *integrators;
    size_t integrator_count;
    int repetitions; /* at least MEASURE_MIN_REPETITIONS */
    size_t error_samples;
    double dark;          /* errors are relative to this share of the picture's largest luminance at the least */
    const char *pictures; /* a folder for the pictures that are compared, or NULL */
} measure_settings;

/* One integrator's. What FAMILY_BARE has besides times is 0 and means nothing, as are the evaluations of those that do not
 * count them. */
typedef struct measurement {
    double ms_median;
    double ms_min;
    int repetitions;
    double evaluations_per_pixel;
    double max_error; /* see comparison.h; infinite if any pixel is negative, infinite or no number */
    double p99_error;
    double brightness; /* all light of the picture, over what it ought to be */
} measurement;

typedef struct scene_measurements {
    measurement *integrators; /* in the settings' order */
    size_t pixels;            /* that the errors were measured at */
    size_t unreliable_pixels; /* that were left out, since the reference did not vouch for its value */
} scene_measurements;

/* Measures all of the integrators in turns, so that whatever slows the machine down for a while hits all alike. `name` is the
 * scene's, for the line that tells of the progress. On failure returns false, with a message and nothing to free. */
bool measure_scene(gl_context *context, const demo_scene *scene, const char *name, const measure_settings *settings,
                   scene_measurements *measurements, char *message, size_t size);

void measure_free(scene_measurements *measurements);

#endif
