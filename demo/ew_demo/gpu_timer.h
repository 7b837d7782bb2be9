/*
 * How long the GPU takes. The answer comes a few frames later, so that nothing waits for it.
 */
#ifndef GPU_TIMER_H
#define GPU_TIMER_H

#include "gl_functions.h"

enum { GPU_TIMER_QUERIES = 4 };

typedef struct gpu_timer {
    GLuint queries[GPU_TIMER_QUERIES]; /* 0 where this GL has no timer, or no GPU */
    unsigned begun;
    unsigned finished;
    double milliseconds; /* the last known time; negative while there is none */
} gpu_timer;

void gpu_timer_create(const gl_functions *gl, gpu_timer *timer);
void gpu_timer_destroy(const gl_functions *gl, gpu_timer *timer);

/* Times what is drawn between the two calls. Only one timer may be running. */
void gpu_timer_begin(const gl_functions *gl, gpu_timer *timer);
void gpu_timer_end(const gl_functions *gl, gpu_timer *timer);

#endif
