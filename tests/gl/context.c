/* Headless GL contexts: what is common to EGL and OSMesa. */
#include "context.h"

#include <stdio.h>
#include <stdlib.h>

struct test_context {
    const test_platform *platform;
    void *native;
};

static _Thread_local const test_platform *current_platform;

test_context *test_context_create(const test_context_desc *desc)
{
    const test_platform *platform = &test_platform_egl;
    if (desc->osmesa) {
#ifdef EW_HAVE_OSMESA
        platform = &test_platform_osmesa;
#else
        fprintf(stderr, "built without OSMesa\n");
        return NULL;
#endif
    }
    void *native = platform->create(desc, desc->share ? desc->share->native : NULL);
    if (native == NULL) {
        fprintf(stderr, "no %s %d.%d context\n", desc->es ? "OpenGL ES" : "OpenGL", desc->major, desc->minor);
        return NULL;
    }
    test_context *context = malloc(sizeof *context);
    if (context == NULL) abort();
    *context = (test_context){platform, native};
    return context;
}

void test_context_make_current(test_context *context)
{
    if (context == NULL) {
        if (current_platform) current_platform->release();
        current_platform = NULL;
        return;
    }
    current_platform = context->platform;
    if (!context->platform->make_current(context->native)) {
        fprintf(stderr, "cannot make the context current\n");
        abort();
    }
}

void test_context_destroy(test_context *context)
{
    if (context == NULL) return;
    context->platform->destroy(context->native);
    free(context);
}

void (*test_context_get_proc_address(void *user, const char *name))(void)
{
    const test_context *context = user;
    return context->platform->get_proc_address(name);
}
