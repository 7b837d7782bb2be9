/*
 * A context with an effect, for tests that draw.
 */
#ifndef EFFECT_CONTEXT_H
#define EFFECT_CONTEXT_H

#include "context.h"

enum { EXIT_WRONG = 1, EXIT_BAD_INPUT = 2, EXIT_NO_CONTEXT = 77 };

typedef struct effect_context {
    gl_context *context;
    ew_effect *effect;
} effect_context;

/* Returns EXIT_SUCCESS or, with a message in which the test is called `name` and nothing to destroy, what the test shall exit
 * with. */
int effect_context_create(const char *name, effect_context *made);
void effect_context_destroy(effect_context *made);

#endif
