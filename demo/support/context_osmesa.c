/*
 * Contexts by OSMesa, with which Mesa renders to memory without any window system. Mesa has it up to version 25.0, so it is
 * built only where CMake finds it.
 */
#include "context_backend.h"
#include "message.h"

#ifdef EW_HAVE_OSMESA

#include <GL/osmesa.h>

#include <stdlib.h>

typedef struct osmesa_state {
    OSMesaContext context;
    int width;
    int height;
    GLubyte buffer[]; /* of framebuffer 0, which OSMesa always has: RGBA */
} osmesa_state;

static bool make_current(void *user)
{
    osmesa_state *state = user;
    return OSMesaMakeCurrent(state->context, state->buffer, GL_UNSIGNED_BYTE, state->width, state->height);
}

static void release(void *user)
{
    (void)user;
    OSMesaMakeCurrent(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
}

static void destroy(void *user)
{
    osmesa_state *state = user;
    OSMesaDestroyContext(state->context);
    free(state);
}

static OSMesaContext create_context(const context_desc *desc, OSMesaContext share)
{
    const bool window = desc->window_width > 0;
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              window ? 24 : 0,
                              OSMESA_STENCIL_BITS,
                              window ? 8 : 0,
                              OSMESA_PROFILE,
                              desc->compatibility ? OSMESA_COMPAT_PROFILE : OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              desc->major,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              desc->minor,
                              0};
    return OSMesaCreateContextAttribs(attributes, share);
}

bool context_create_osmesa(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                           size_t size)
{
    const int width = desc->window_width > 0 ? desc->window_width : 1;
    const int height = desc->window_width > 0 ? desc->window_height : 1;
    const osmesa_state *shared = share;
    osmesa_state *state = calloc(1, sizeof *state + 4 * (size_t)width * (size_t)height);
    const char *failure = "memory is exhausted";
    if (state) {
        state->width = width;
        state->height = height;
        state->context = desc->es ? NULL : create_context(desc, shared ? shared->context : NULL);
        *implementation = (context_implementation){.name = "OSMesa",
                                                   .state = state,
                                                   .make_current = make_current,
                                                   .release = release,
                                                   .get_proc_address = OSMesaGetProcAddress,
                                                   .destroy = destroy};
        if (state->context && make_current(state)) return true;
        failure = state->context ? "the context could not be made current" : "the driver refused the context";
        if (state->context) OSMesaDestroyContext(state->context);
        free(state);
    }
    message_write(message, size, "OSMesa: %s", failure);
    return false;
}

#else

bool context_create_osmesa(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                           size_t size)
{
    (void)desc, (void)share, (void)implementation;
    message_write(message, size, "OSMesa: this program was built without it");
    return false;
}

#endif
