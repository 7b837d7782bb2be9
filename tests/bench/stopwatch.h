/*
 * How long GL takes to draw: by its own timer where that measures something, else from glFinish to glFinish.
 */
#ifndef STOPWATCH_H
#define STOPWATCH_H

#include "context.h"

typedef struct bench_stopwatch {
    const gl_functions *gl;
    /* Of a context whose timer is used; GenQueries is NULL in the others. */
    PFNGLGENQUERIESPROC GenQueries;
    PFNGLDELETEQUERIESPROC DeleteQueries;
    PFNGLBEGINQUERYPROC BeginQuery;
    PFNGLENDQUERYPROC EndQuery;
    PFNGLGETQUERYOBJECTUI64VPROC GetQueryObjectui64v;
    GLuint query;
    double started; /* milliseconds */
} bench_stopwatch;

/* The context must be current, here and below. */
bench_stopwatch stopwatch_create(gl_context *context);
void stopwatch_destroy(bench_stopwatch *stopwatch);

bool stopwatch_is_gl_timer(const bench_stopwatch *stopwatch);

/* Waits until GL has nothing left to do, and starts. */
void stopwatch_start(bench_stopwatch *stopwatch);

/* Waits until GL has drawn all since the start; returns the milliseconds that took. */
double stopwatch_stop(bench_stopwatch *stopwatch);

#endif
