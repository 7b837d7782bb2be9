/*
 * What a backend provides. Only context.c uses this; only context_egl.c, context_osmesa.c, context_webgl.c and context_wgl.c
 * implement it.
 */
#ifndef CONTEXT_BACKEND_H
#define CONTEXT_BACKEND_H

#include "context.h"

typedef struct context_implementation {
    const char *name; /* for users, such as "EGL, surfaceless" */
    void *state;
    bool (*make_current)(void *state); /* called while no other context is current */
    void (*release)(void *state);      /* called while this one is current */
    ew_gl_function (*get_proc_address)(const char *name);
    void (*destroy)(void *state); /* called while this one is not current; frees `state` */
} context_implementation;

/* Each creates a context and makes it current; called while none is current. `share` is the state of the context to share
 * objects with, or NULL. On failure returns false, with the reason in `message`. */
bool context_create_egl(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                        size_t size);
bool context_create_osmesa(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                           size_t size);
bool context_create_webgl(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                          size_t size);
bool context_create_wgl(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                        size_t size);

#endif
