/* A context with an effect: see effect_context.h. */
#include "effect_context.h"

#include <stdio.h>
#include <stdlib.h>

int effect_context_create(const char *name, effect_context *made)
{
    char message[400];
    ew_error error;
    /* Mesa's EGL would add lines of its own to the one that says why there is no context. */
    made->context = context_create(CONTEXT_EGL, message, sizeof message);
    if (!made->context) {
        printf("SKIPPED: %s\n", message);
        return EXIT_NO_CONTEXT;
    }
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = made->context};
    if (ew_create_effect(&desc, &made->effect, &error) == EW_OK) return EXIT_SUCCESS;
    fprintf(stderr, "%s: %s\n", name, error.text);
    context_destroy(made->context);
    return EXIT_BAD_INPUT;
}

void effect_context_destroy(effect_context *made)
{
    ew_destroy_effect(made->effect);
    context_destroy(made->context);
}
