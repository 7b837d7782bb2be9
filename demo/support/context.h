/*
 * GL contexts without a window, behind one interface: EGL and, where it was found at build time, OSMesa. Several may exist at
 * once, of either kind; each call below makes current, or needs current, exactly the one it is given.
 */
#ifndef CONTEXT_H
#define CONTEXT_H

#include "energywave.h"
#include "gl_functions.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum context_backend {
    CONTEXT_AUTO, /* EGL or else OSMesa */
    CONTEXT_EGL,
    CONTEXT_OSMESA,
} context_backend;

typedef struct gl_context gl_context;

/* The names of the backends as users write them, in the order of the enumeration, up to a NULL. */
extern const char *const context_backend_names[];

/* Creates an OpenGL 3.3 core (or later) context and makes it current. Returns NULL, with one line of what to mend in
 * `message`, where there is none; no context is current then. */
gl_context *context_create(context_backend backend, char *message, size_t size);

bool context_make_current(gl_context *context);

/* Leaves no context current. `context` may be NULL. */
void context_destroy(gl_context *context);

/* The functions of this context, which must be current when they are called. */
const gl_functions *context_gl(const gl_context *context);

/* For ew_effect_desc: `user` is the context. */
ew_gl_function context_get_proc_address(void *user, const char *name);

/* One line: backend, vendor, renderer and version. */
const char *context_description(const gl_context *context);

#endif
