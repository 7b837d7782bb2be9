/* GL contexts without a window: see context.h. */
#include "context.h"
#include "context_backend.h"
#include "message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct gl_context {
    context_implementation implementation;
    gl_functions gl;
    char description[400];
};

typedef bool create_function(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                             size_t size);

#ifdef _WIN32
const char *const context_backend_names[] = {"auto", "wgl", NULL};
static create_function *const create_functions[] = {NULL, context_create_wgl};
#elif defined(__EMSCRIPTEN__)
const char *const context_backend_names[] = {"auto", "webgl", NULL};
static create_function *const create_functions[] = {NULL, context_create_webgl};
#else
const char *const context_backend_names[] = {"auto", "egl", "osmesa", NULL};
static create_function *const create_functions[] = {NULL, context_create_egl, context_create_osmesa};
#endif

/* This thread's current context. No backend knows of another: each would still report its own context as current after another
 * has replaced it. */
static _Thread_local gl_context *current;

static void release_current(void)
{
    if (current) current->implementation.release(current->implementation.state);
    current = NULL;
}

static bool create_implementation(const context_desc *desc, context_implementation *implementation, char *message, size_t size)
{
    void *share = desc->share ? desc->share->implementation.state : NULL;
    if (desc->backend != CONTEXT_AUTO) return create_functions[desc->backend](desc, share, implementation, message, size);
    char reasons[400] = "", reason[200];
    for (size_t i = 1; context_backend_names[i]; i++) {
        if (create_functions[i](desc, NULL, implementation, reason, sizeof reason)) return true;
        size_t length = strlen(reasons);
        snprintf(reasons + length, sizeof reasons - length, "%s%s", length ? "; " : "", reason);
    }
    message_write(message, size, "%s", reasons);
    return false;
}

gl_context *context_create_described(const context_desc *desc, char *message, size_t size)
{
    release_current();
    gl_context *context = calloc(1, sizeof *context);
    message_write(message, size, "memory is exhausted");
    if (context && create_implementation(desc, &context->implementation, message, size)) return current = context;
    free(context);
    return NULL;
}

/* Returns whether all functions are there; where one is not, `reason` names it. */
static bool load_functions(gl_context *context, char *reason, size_t size)
{
    const gl_functions *gl = &context->gl;
    const char *missing = gl_load_functions(&context->gl, context_get_proc_address, context);
    if (missing) {
        message_write(reason, size, "%s has no %s", context->implementation.name, missing);
        return false;
    }
    message_write(context->description, sizeof context->description, "%s: %s, %s, %s", context->implementation.name,
                  (const char *)gl->GetString(GL_VENDOR), (const char *)gl->GetString(GL_RENDERER),
                  (const char *)gl->GetString(GL_VERSION));
    return true;
}

gl_context *context_create(context_backend backend, char *message, size_t size)
{
    const context_desc desc = {.backend = backend, .major = 3, .minor = 3};
    char reason[400];
    gl_context *context = context_create_described(&desc, reason, sizeof reason);
    if (context && load_functions(context, reason, sizeof reason)) return context;
    context_destroy(context);
    message_write(message, size, "--backend %s: no OpenGL 3.3 core context (%s); install a GL driver or name another backend",
                  context_backend_names[backend], reason);
    return NULL;
}

bool context_make_current(gl_context *context)
{
    if (context == current) return true;
    release_current();
    if (context && context->implementation.make_current(context->implementation.state)) current = context;
    return context == current;
}

void context_destroy(gl_context *context)
{
    if (!context) return;
    if (context == current) release_current();
    context->implementation.destroy(context->implementation.state);
    free(context);
}

const gl_functions *context_gl(const gl_context *context)
{
    return &context->gl;
}

ew_gl_function context_get_proc_address(void *user, const char *name)
{
    const gl_context *context = user;
    return context->implementation.get_proc_address(name);
}

const char *context_description(const gl_context *context)
{
    return context->description;
}
