/*
 * What a run of the benchmark found, for those who write it down.
 */
#ifndef RESULTS_H
#define RESULTS_H

#include "measure.h"

typedef struct bench_scene {
    const char *path;
    char name[64]; /* the file's, without folders and .json */
    scene_measurements measurements;
} bench_scene;

typedef struct bench_machine {
    char processor[128];
    long cores;
    char renderer[128];
    char version[128];    /* of GL */
    bool has_gl_timer;    /* times are GL's own */
    double multiply_adds; /* that fragment shaders can do in a millisecond: see peer_multiply_add.h */
} bench_machine;

/* Of scenes that are measured alike. */
typedef struct bench_results {
    const char *title;
    bool is_frames; /* as games have them, to be summed up by all that is compared */
    measure_settings settings;
    bench_machine machine;
    bench_scene *scenes;
    size_t scene_count;
} bench_results;

/* The integrator's measurement in a scene by its name; NULL if it was not measured. */
const measurement *results_find(const bench_results *results, const bench_scene *scene, const char *integrator);

/* Asks the operating system and the current context. On failure returns false, with a message. */
bool machine_describe(gl_context *context, bench_machine *machine, char *message, size_t size);

/* How many multiply-adds a pixel the machine can do in the time of a frame. */
double results_multiply_adds(const bench_results *results, double ms);

#endif
