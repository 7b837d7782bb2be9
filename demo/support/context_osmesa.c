/*
 * Contexts by OSMesa, Mesa's rendering to memory without any window system. Newer Mesa versions no longer have it, so
 * whether it is built is decided when CMake looks for it.
 */
#include "context_backend.h"
#include "message.h"

#ifdef EW_HAVE_OSMESA

#include <GL/osmesa.h>

#include <stdlib.h>

enum { BUFFER_SIDE = 4 };

typedef struct osmesa_state {
    OSMesaContext context;
    /* OSMesa wants a default framebuffer; nothing here draws to it. */
    GLubyte buffer[BUFFER_SIDE * BUFFER_SIDE * 4];
} osmesa_state;

static bool make_current(void *user)
{
    osmesa_state *state = user;
    return OSMesaMakeCurrent(state->context, state->buffer, GL_UNSIGNED_BYTE, BUFFER_SIDE, BUFFER_SIDE);
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

bool context_create_osmesa(context_implementation *implementation, char *message, size_t size)
{
    static const int attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    osmesa_state *state = calloc(1, sizeof *state);
    const char *failure = "memory is exhausted";
    if (state) {
        state->context = OSMesaCreateContextAttribs(attributes, NULL);
        if (state->context && make_current(state)) {
            *implementation = (context_implementation){.name = "OSMesa",
                                                       .state = state,
                                                       .make_current = make_current,
                                                       .release = release,
                                                       .get_proc_address = OSMesaGetProcAddress,
                                                       .destroy = destroy};
            return true;
        }
        failure = state->context ? "the context could not be made current" : "the driver refused the context";
        if (state->context) OSMesaDestroyContext(state->context);
        free(state);
    }
    message_write(message, size, "OSMesa: %s", failure);
    return false;
}

#else

bool context_create_osmesa(context_implementation *implementation, char *message, size_t size)
{
    (void)implementation;
    message_write(message, size, "OSMesa: this program was built without it");
    return false;
}

#endif
