/* The contexts in which test programs run: see program_context.h. */
#include "program_context.h"
#include "debug_output.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

bool describe_context(const char *name, context_desc *desc)
{
    static const struct {
        const char *name;
        context_desc desc;
    } kinds[] = {
#ifdef _WIN32
        {"gl33", {.backend = CONTEXT_WGL, .major = 3, .minor = 3}},
        {"gl45", {.backend = CONTEXT_WGL, .major = 4, .minor = 5}},
        {"gl45_compatibility", {.backend = CONTEXT_WGL, .major = 4, .minor = 5, .compatibility = true}},
#else
        {"gl33", {.backend = CONTEXT_EGL, .major = 3, .minor = 3}},
        {"gl45", {.backend = CONTEXT_EGL, .major = 4, .minor = 5}},
        {"gl45_compatibility", {.backend = CONTEXT_EGL, .major = 4, .minor = 5, .compatibility = true}},
        {"es30", {.backend = CONTEXT_EGL, .es = true, .major = 3, .minor = 0}},
        {"es31", {.backend = CONTEXT_EGL, .es = true, .major = 3, .minor = 1}},
        {"es32", {.backend = CONTEXT_EGL, .es = true, .major = 3, .minor = 2}},
        {"osmesa33", {.backend = CONTEXT_OSMESA, .major = 3, .minor = 3, .window_width = 48, .window_height = 36}},
        {"osmesa45_compatibility",
         {.backend = CONTEXT_OSMESA, .major = 4, .minor = 5, .compatibility = true, .window_width = 48, .window_height = 36}},
#endif
    };
    for (size_t i = 0; name && i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(name, kinds[i].name) != 0) continue;
        *desc = kinds[i].desc;
        return true;
    }
    fprintf(stderr, "the argument must name a kind of context: see program_context.h\n");
    return false;
}

gl_context *open_described_context(const context_desc *desc)
{
    char message[400];
    context_desc watched = *desc;
    watched.debug = true;
    gl_context *context = context_create_described(&watched, message, sizeof message);
    if (context == NULL) {
        fprintf(stderr, "no %s %d.%d context: %s\n", desc->es ? "OpenGL ES" : "OpenGL", desc->major, desc->minor, message);
        return NULL;
    }
    api_load(context);
    debug_output_watch();
    fprintf(stderr, "%s, %s\n", (const char *)gl.GetString(GL_RENDERER), (const char *)gl.GetString(GL_VERSION));
    return context;
}

gl_context *open_context(const char *name, gl_context *share)
{
    context_desc desc;
    if (!describe_context(name, &desc)) return NULL;
    desc.share = share;
    return open_described_context(&desc);
}

void close_context(gl_context *context)
{
    context_make_current(NULL);
    context_destroy(context);
}

void gl_has_nothing_to_say(void **state)
{
    (void)state;
    assert_int_equal(debug_output_count(), 0);
}
