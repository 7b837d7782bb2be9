/* Headless GL contexts: what is common to EGL and OSMesa. */
#include "context.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct test_context {
    const test_platform *platform;
    void *native;
};

static _Thread_local const test_platform *current_platform;

bool test_context_describe(const char *name, test_context_desc *desc)
{
    static const struct {
        const char *name;
        test_context_desc desc;
    } kinds[] = {
        {"gl33", {.major = 3, .minor = 3}},
        {"gl45", {.major = 4, .minor = 5}},
        {"gl45_compatibility", {.major = 4, .minor = 5, .compatibility = true}},
        {"es30", {.es = true, .major = 3, .minor = 0}},
        {"es31", {.es = true, .major = 3, .minor = 1}},
        {"es32", {.es = true, .major = 3, .minor = 2}},
        {"osmesa33", {.osmesa = true, .major = 3, .minor = 3}},
        {"osmesa45_compatibility", {.osmesa = true, .major = 4, .minor = 5, .compatibility = true}},
    };
    for (size_t i = 0; name && i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(name, kinds[i].name) != 0) continue;
        *desc = kinds[i].desc;
        return true;
    }
    fprintf(stderr, "the argument must name a kind of context: see context.h\n");
    return false;
}

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
