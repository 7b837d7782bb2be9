/* Headless GL contexts of every kind that the library supports, for tests. */
#ifndef TEST_CONTEXT_H
#define TEST_CONTEXT_H

#include <stdbool.h>

typedef struct test_context test_context;

enum { TEST_WINDOW_WIDTH = 48, TEST_WINDOW_HEIGHT = 36 };

typedef struct test_context_desc {
    bool osmesa; /* else EGL, without a display */
    bool es;
    int major;
    int minor;
    bool compatibility;
    bool window; /* with a window's framebuffer, framebuffer 0, of TEST_WINDOW_WIDTH x TEST_WINDOW_HEIGHT, 8 bit RGBA, with
                    depth and stencil (OSMesa's contexts always have one) */
    int window_samples;  /* of that */
    test_context *share; /* a context of the same description to share objects with, or NULL */
} test_context_desc;

/* Describes the kind of context of that name: gl33, gl45, gl45_compatibility, es30, es31, es32, osmesa33 or
 * osmesa45_compatibility. False, with a line on stderr, if there is none. */
bool test_context_describe(const char *name, test_context_desc *desc);

/* A debug context where the platform has them. NULL, with a line on stderr, if there is none. */
test_context *test_context_create(const test_context_desc *desc);
void test_context_make_current(test_context *context); /* NULL: none is current */
void test_context_destroy(test_context *context);

/* The loader of the current context: `user` is the test_context. */
void (*test_context_get_proc_address(void *user, const char *name))(void);

/* What a platform implements. */
typedef struct test_platform {
    void *(*create)(const test_context_desc *desc, void *share);
    bool (*make_current)(void *native);
    void (*release)(void);
    void (*destroy)(void *native);
    void (*(*get_proc_address)(const char *name))(void);
} test_platform;

extern const test_platform test_platform_egl;
extern const test_platform test_platform_osmesa; /* only where EW_HAVE_OSMESA is defined */

#endif
