/*
 * Contexts by EGL, without a window system: on the first hardware device that works, or else on Mesa's surfaceless platform,
 * which is no device in particular.
 */
#include "context_backend.h"
#include "message.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdlib.h>
#include <string.h>

enum { MAX_DEVICES = 16 };

typedef struct egl_state {
    EGLDisplay display;
    EGLContext context;
    EGLSurface surface; /* EGL_NO_SURFACE where there is no framebuffer 0 */
    EGLenum api;
} egl_state;

static bool has_extension(const char *extensions, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = extensions; at && (at = strstr(at, name)); at += length)
        if ((at == extensions || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) return true;
    return false;
}

static bool make_current(void *user)
{
    egl_state *state = user;
    return eglBindAPI(state->api) && eglMakeCurrent(state->display, state->surface, state->surface, state->context);
}

static void release(void *user)
{
    egl_state *state = user;
    eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void destroy_objects(egl_state *state)
{
    if (state->surface != EGL_NO_SURFACE) eglDestroySurface(state->display, state->surface);
    if (state->context != EGL_NO_CONTEXT) eglDestroyContext(state->display, state->context);
}

static void destroy(void *user)
{
    destroy_objects(user);
    /* The display stays: everyone who asks for it gets the same one. */
    free(user);
}

static bool choose_config(EGLDisplay display, const context_desc *desc, EGLConfig *config)
{
    const bool window = desc->window_width > 0;
    const EGLint attributes[] = {EGL_RENDERABLE_TYPE,
                                 desc->es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                                 EGL_SURFACE_TYPE,
                                 window ? EGL_PBUFFER_BIT : 0,
                                 EGL_RED_SIZE,
                                 window ? 8 : 0,
                                 EGL_ALPHA_SIZE,
                                 window ? 8 : 0,
                                 EGL_DEPTH_SIZE,
                                 window ? 24 : 0,
                                 EGL_STENCIL_SIZE,
                                 window ? 8 : 0,
                                 EGL_SAMPLES,
                                 desc->window_samples,
                                 EGL_NONE};
    EGLint count = 0;
    return eglChooseConfig(display, attributes, config, 1, &count) && count > 0;
}

static EGLContext create_context(EGLDisplay display, EGLConfig config, EGLContext share, const context_desc *desc)
{
    EGLint attributes[9] = {EGL_CONTEXT_MAJOR_VERSION, desc->major, EGL_CONTEXT_MINOR_VERSION, desc->minor};
    int count = 4;
    if (!desc->es) {
        attributes[count++] = EGL_CONTEXT_OPENGL_PROFILE_MASK;
        attributes[count++] =
            desc->compatibility ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;
    }
    if (desc->debug) {
        attributes[count++] = EGL_CONTEXT_OPENGL_DEBUG;
        attributes[count++] = EGL_TRUE;
    }
    attributes[count] = EGL_NONE;
    return eglCreateContext(display, config, share, attributes);
}

/* Creates the state's objects on `display` and makes the context current; returns what failed, or NULL. */
static const char *create_objects(EGLDisplay display, EGLContext share, const context_desc *desc, egl_state *state)
{
    EGLConfig config;
    *state = (egl_state){.display = display,
                         .context = EGL_NO_CONTEXT,
                         .surface = EGL_NO_SURFACE,
                         .api = desc->es ? EGL_OPENGL_ES_API : EGL_OPENGL_API};
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) return "no display could be initialised";
    if (!has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return "EGL_KHR_surfaceless_context is missing";
    if (!choose_config(display, desc, &config)) return "no OpenGL configuration";
    if (!eglBindAPI(state->api)) return "OpenGL is not supported";
    state->context = create_context(display, config, share, desc);
    if (state->context == EGL_NO_CONTEXT) return "the driver refused the context";
    if (desc->window_width > 0) {
        const EGLint attributes[] = {EGL_WIDTH, desc->window_width, EGL_HEIGHT, desc->window_height, EGL_NONE};
        state->surface = eglCreatePbufferSurface(display, config, attributes);
        if (state->surface == EGL_NO_SURFACE) return "the driver refused the framebuffer";
    }
    return make_current(state) ? NULL : "the context could not be made current";
}

static const char *create_on_display(EGLDisplay display, EGLContext share, const context_desc *desc, egl_state *state)
{
    const char *failure = create_objects(display, share, desc, state);
    if (failure) destroy_objects(state);
    return failure;
}

static bool create_on_hardware(const char *client_extensions, PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display,
                               const context_desc *desc, egl_state *state)
{
    PFNEGLQUERYDEVICESEXTPROC query_devices = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string =
        (PFNEGLQUERYDEVICESTRINGEXTPROC)eglGetProcAddress("eglQueryDeviceStringEXT");
    EGLDeviceEXT devices[MAX_DEVICES];
    EGLint count = 0;
    if (!has_extension(client_extensions, "EGL_EXT_platform_device") || !query_devices || !query_device_string) return false;
    if (!query_devices(MAX_DEVICES, devices, &count)) return false;
    for (EGLint i = 0; i < count; i++) {
        if (has_extension(query_device_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) continue;
        if (!create_on_display(get_platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL), EGL_NO_CONTEXT, desc, state))
            return true;
    }
    return false;
}

/* Creates the state on the best display there is, and names that in `name`; returns what failed, or NULL. */
static const char *create_on_best_display(const context_desc *desc, egl_state *state, const char **name)
{
    /* By the EXT name: client libraries of EGL 1.4 lack the one of EGL 1.5. */
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    const char *client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!get_platform_display) return "EGL_EXT_platform_base is missing";
    *name = "EGL, hardware device";
    if (create_on_hardware(client_extensions, get_platform_display, desc, state)) return NULL;
    *name = "EGL, surfaceless";
    if (!has_extension(client_extensions, "EGL_MESA_platform_surfaceless"))
        return "neither a hardware device nor Mesa's surfaceless platform works";
    EGLDisplay surfaceless = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    return create_on_display(surfaceless, EGL_NO_CONTEXT, desc, state);
}

bool context_create_egl(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                        size_t size)
{
    /* Mesa's EGL would add lines of its own to the one that says why there is no context. */
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    egl_state *state = calloc(1, sizeof *state), *shared = share;
    *implementation = (context_implementation){.name = "EGL, shared",
                                               .state = state,
                                               .make_current = make_current,
                                               .release = release,
                                               .get_proc_address = eglGetProcAddress,
                                               .destroy = destroy};
    const char *failure = !state   ? "memory is exhausted"
                          : shared ? create_on_display(shared->display, shared->context, desc, state)
                                   : create_on_best_display(desc, state, &implementation->name);
    if (!failure) return true;
    free(state);
    message_write(message, size, "EGL: %s", failure);
    return false;
}
