/* Contexts that draw to memory through OSMesa, which Mesa has up to version 25.0. */
#include "context.h"

#include <GL/osmesa.h>
#include <stdlib.h>

typedef struct osmesa {
    OSMesaContext context;
    unsigned char buffer[4 * TEST_WINDOW_WIDTH * TEST_WINDOW_HEIGHT];
} osmesa;

static void *create(const test_context_desc *desc, void *share)
{
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              desc->compatibility ? OSMESA_COMPAT_PROFILE : OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              desc->major,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              desc->minor,
                              0};
    osmesa *native = malloc(sizeof *native);
    if (native == NULL) abort();
    native->context = OSMesaCreateContextAttribs(attributes, share ? ((osmesa *)share)->context : NULL);
    if (native->context == NULL) {
        free(native);
        return NULL;
    }
    return native;
}

static bool make_current(void *native)
{
    osmesa *current = native;
    return OSMesaMakeCurrent(current->context, current->buffer, GL_UNSIGNED_BYTE, TEST_WINDOW_WIDTH, TEST_WINDOW_HEIGHT);
}

static void release(void)
{
    OSMesaMakeCurrent(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
}

static void destroy(void *native)
{
    OSMesaDestroyContext(((osmesa *)native)->context);
    free(native);
}

static void (*get_proc_address(const char *name))(void)
{
    return OSMesaGetProcAddress(name);
}

const test_platform test_platform_osmesa = {create, make_current, release, destroy, get_proc_address};
