/*
 * How long the GPU takes for something, known a few frames later so that nothing waits for it.
 */
#ifndef GPU_TIMER_H
#define GPU_TIMER_H

#include "gl_functions.h"

enum { GPU_TIMER_QUERIES = 4 };

typedef struct gpu_timer {
    GLuint queries[GPU_TIMER_QUERIES]; /* 0 where this GL has no timer */
    unsigned begun;
    unsigned finished;
    double milliseconds; /* of the last that is known; negative while none is */
} gpu_timer;

void gpu_timer_create(const gl_functions *gl, gpu_timer *timer);
void gpu_timer_destroy(const gl_functions *gl, gpu_timer *timer);

/* What stands between the two is timed. One timer at a time. */
void gpu_timer_begin(const gl_functions *gl, gpu_timer *timer);
void gpu_timer_end(const gl_functions *gl, gpu_timer *timer);

#endif
