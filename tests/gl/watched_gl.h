/* A loader that stands between the library and a context: it counts the objects that are made and deleted and the shaders that
 * are compiled, and can play a driver that compiles on other threads, or one that refuses shaders. */
#ifndef TEST_WATCHED_GL_H
#define TEST_WATCHED_GL_H

#include "context.h"
#include "energywave.h"

typedef struct watched_gl {
    gl_context *context;
    int loaded;  /* functions that were asked for */
    int objects; /* made and not yet deleted */
    int compiled, linked, drawn;
    /* To be set before an effect is created. How often a program is to say that it is not complete, or -1 for the driver's own
     * ways. */
    int completion_delay;
    int asked_too_early;       /* questions that would have had to wait for the compiler */
    const char *refused_stage; /* NULL, "vertex" or "fragment": of those, what is compiled is no GLSL */
} watched_gl;

/* All effects are watched through the one that was started last. */
void watched_gl_start(watched_gl *watched, gl_context *context);

/* For ew_effect_desc. */
ew_gl_function watched_gl_get_proc_address(void *user, const char *name);

#endif
