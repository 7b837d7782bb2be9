/*
 * GL contexts without a visible window, behind one interface: EGL and, where it was found at build time, OSMesa; WGL on
 * Windows; WebGL in browsers, where a page has one. Elsewhere several may exist at once, of any kind.
 */
#ifndef CONTEXT_H
#define CONTEXT_H

#include "energywave.h"
#include "gl_functions.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum context_backend {
    CONTEXT_AUTO, /* the first of the others that works */
#ifdef _WIN32
    CONTEXT_WGL,
#elif defined(__EMSCRIPTEN__)
    CONTEXT_WEBGL,
#else
    CONTEXT_EGL,
    CONTEXT_OSMESA,
#endif
} context_backend;

/* What users call the backends, in the order of the enumeration, up to a NULL. */
extern const char *const context_backend_names[];

typedef struct gl_context gl_context;

typedef struct context_desc {
    context_backend backend;
    bool es;            /* OpenGL ES, which OSMesa lacks */
    int major;          /* the oldest version that will do */
    int minor;          /* likewise */
    bool compatibility; /* the compatibility profile instead of the core profile */
    bool debug;         /* a debug context, where the backend has them */
    int window_width;   /* of framebuffer 0: 8-bit RGBA with depth and stencil; 0 for no such framebuffer */
    int window_height;
    int window_samples; /* of framebuffer 0, by EGL only */
    gl_context *share;  /* a context of the same description to share objects with, or NULL; `backend` is not CONTEXT_AUTO */
} context_desc;

/* Creates a context and makes it current. On failure returns NULL, with the reason in `message`; no context is current then. */
gl_context *context_create_described(const context_desc *desc, char *message, size_t size);

/* The same for OpenGL 3.3 core, with its functions loaded. `message` says what to mend. */
gl_context *context_create(context_backend backend, char *message, size_t size);

/* Makes `context` current on this thread; with NULL, none. */
bool context_make_current(gl_context *context);

/* The context must not be current on another thread. If it is current on this one, none is afterwards. `context` may be NULL.
 */
void context_destroy(gl_context *context);

/* The functions of a context from context_create. It must be current when they are called. */
const gl_functions *context_gl(const gl_context *context);

/* For ew_effect_desc: `user` is the context. */
ew_gl_function context_get_proc_address(void *user, const char *name);

/* Backend, vendor, renderer and version of a context from context_create, on one line. */
const char *context_description(const gl_context *context);

#endif
