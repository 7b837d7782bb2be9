/*
 * Contexts by EGL, without a window system: on the first hardware device that works, or else on no device in particular,
 * which is Mesa's surfaceless platform.
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
    return eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context);
}

static void release(void *user)
{
    egl_state *state = user;
    eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void destroy(void *user)
{
    egl_state *state = user;
    eglDestroyContext(state->display, state->context);
    /* The display itself is shared by all who asked for it, and is left to live. */
    free(state);
}

/* Makes a context on `display` current; returns what failed, or NULL. */
static const char *create_on_display(EGLDisplay display, egl_state *state)
{
    static const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    static const EGLint context_attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) return "no display could be initialised";
    if (!has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return "EGL_KHR_surfaceless_context is missing";
    if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count == 0) return "no OpenGL configuration";
    if (!eglBindAPI(EGL_OPENGL_API)) return "OpenGL is not supported";
    state->display = display;
    state->context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
    if (state->context == EGL_NO_CONTEXT) return "the driver refused the context";
    if (make_current(state)) return NULL;
    eglDestroyContext(display, state->context);
    return "the context could not be made current";
}

static bool create_on_hardware(const char *client_extensions, PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display,
                               egl_state *state)
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
        if (!create_on_display(get_platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL), state)) return true;
    }
    return false;
}

bool context_create_egl(context_implementation *implementation, char *message, size_t size)
{
    /* The EXT name: the EGL 1.5 one is not there where the client library is of 1.4. */
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    const char *client_extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    egl_state *state = calloc(1, sizeof *state);
    const char *failure = "memory is exhausted";
    *implementation = (context_implementation){.state = state,
                                               .make_current = make_current,
                                               .release = release,
                                               .get_proc_address = eglGetProcAddress,
                                               .destroy = destroy};
    if (state && get_platform_display) {
        implementation->name = "EGL, hardware device";
        if (create_on_hardware(client_extensions, get_platform_display, state)) return true;
        implementation->name = "EGL, surfaceless";
        failure = has_extension(client_extensions, "EGL_MESA_platform_surfaceless")
                      ? create_on_display(get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL), state)
                      : "neither a hardware device nor Mesa's surfaceless platform works";
        if (!failure) return true;
    } else if (state) {
        failure = "EGL_EXT_platform_base is missing";
    }
    free(state);
    message_write(message, size, "EGL: %s", failure);
    return false;
}
