/*
 * What a kind of context provides: context.c alone uses it, context_egl.c and context_osmesa.c alone implement it.
 */
#ifndef CONTEXT_BACKEND_H
#define CONTEXT_BACKEND_H

#include <stdbool.h>
#include <stddef.h>

typedef void (*context_function)(void);

typedef struct context_implementation {
    /* What the user is told it is, such as "EGL, surfaceless". */
    const char *name;
    void *state;
    /* Called with no other context current. */
    bool (*make_current)(void *state);
    /* Called with this one current. */
    void (*release)(void *state);
    context_function (*get_proc_address)(const char *name);
    /* Called after release; frees `state`. */
    void (*destroy)(void *state);
} context_implementation;

/* Each creates a context and makes it current, called with none current, or says on one line why it cannot. */
bool context_create_egl(context_implementation *implementation, char *message, size_t size);
bool context_create_osmesa(context_implementation *implementation, char *message, size_t size);

#endif
