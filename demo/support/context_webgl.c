/*
 * Contexts of WebGL 2, by Emscripten, on the page's canvas. A canvas has one context, and keeps it.
 */
#include "context_backend.h"
#include "message.h"

#include <emscripten/html5.h>

#include <stdint.h>
#include <stdlib.h>

static const char canvas[] = "#canvas";

typedef struct webgl_state {
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context;
} webgl_state;

static bool make_current(void *user)
{
    webgl_state *state = user;
    return emscripten_webgl_make_context_current(state->context) == EMSCRIPTEN_RESULT_SUCCESS;
}

static void release(void *user)
{
    (void)user;
    emscripten_webgl_make_context_current(0);
}

static void destroy(void *user)
{
    webgl_state *state = user;
    emscripten_webgl_destroy_context(state->context);
    free(state);
}

static ew_gl_function get_proc_address(const char *name)
{
    return (ew_gl_function)(uintptr_t)emscripten_webgl_get_proc_address(name);
}

bool context_create_webgl(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                          size_t size)
{
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.antialias = desc->window_samples > 0;
    if (desc->window_width > 0) emscripten_set_canvas_element_size(canvas, desc->window_width, desc->window_height);
    webgl_state *state = share ? NULL : calloc(1, sizeof *state);
    if (state) state->context = emscripten_webgl_create_context(canvas, &attributes);
    if (!state || state->context <= 0 || !make_current(state)) {
        free(state);
        message_write(message, size, "WebGL: the page's canvas \"%s\" has no context of WebGL 2", canvas);
        return false;
    }
    *implementation = (context_implementation){"WebGL", state, make_current, release, get_proc_address, destroy};
    return true;
}
