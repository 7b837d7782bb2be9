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
    char version[128]; /* of GL */
    bool has_gl_timer; /* times are GL's own */
} bench_machine;

typedef struct bench_results {
    measure_settings settings;
    bench_machine machine;
    bench_scene *scenes;
    size_t scene_count;
} bench_results;

/* The integrator's measurement in a scene by its name; NULL if it was not measured. */
const measurement *results_find(const bench_results *results, const bench_scene *scene, const char *integrator);

/* Asks the operating system and the current context. */
bench_machine machine_describe(gl_context *context);

#endif
