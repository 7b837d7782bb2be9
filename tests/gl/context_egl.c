/* Contexts through EGL, without a display. */
#include "context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdlib.h>

static EGLDisplay open_display(void)
{
    static EGLDisplay display = EGL_NO_DISPLAY;
    if (display != EGL_NO_DISPLAY) return display;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    if (get_platform_display) display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, (void *)EGL_DEFAULT_DISPLAY, NULL);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) {
        display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) return display = EGL_NO_DISPLAY;
    }
    return display;
}

typedef struct egl {
    EGLContext context;
    EGLSurface surface; /* or none */
} egl;

static bool choose_config(EGLDisplay display, const test_context_desc *desc, EGLConfig *config)
{
    const EGLint kind = desc->es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT;
    const EGLint surfaceless[] = {EGL_RENDERABLE_TYPE, kind, EGL_SURFACE_TYPE, 0, EGL_NONE};
    const EGLint window[] = {EGL_RENDERABLE_TYPE,
                             kind,
                             EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_STENCIL_SIZE,
                             8,
                             EGL_SAMPLES,
                             desc->window_samples,
                             EGL_NONE};
    EGLint count = 0;
    return eglChooseConfig(display, desc->window ? window : surfaceless, config, 1, &count) && count > 0;
}

static void *create(const test_context_desc *desc, void *share)
{
    EGLDisplay display = open_display();
    EGLConfig config;
    if (display == EGL_NO_DISPLAY || !choose_config(display, desc, &config)) return NULL;

    const EGLint profile =
        desc->compatibility ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 desc->major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 desc->minor,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 EGL_TRUE,
                                 desc->es ? EGL_NONE : EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 profile,
                                 EGL_NONE};
    eglBindAPI(desc->es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    egl created = {.surface = EGL_NO_SURFACE};
    created.context = eglCreateContext(display, config, share ? ((egl *)share)->context : EGL_NO_CONTEXT, attributes);
    if (created.context == EGL_NO_CONTEXT) return NULL;
    if (desc->window) {
        const EGLint size[] = {EGL_WIDTH, TEST_WINDOW_WIDTH, EGL_HEIGHT, TEST_WINDOW_HEIGHT, EGL_NONE};
        created.surface = eglCreatePbufferSurface(display, config, size);
        if (created.surface == EGL_NO_SURFACE) {
            eglDestroyContext(display, created.context);
            return NULL;
        }
    }
    egl *native = malloc(sizeof *native);
    if (native == NULL) abort();
    *native = created;
    return native;
}

static bool make_current(void *native)
{
    const egl *made = native;
    EGLint api = EGL_OPENGL_API;
    eglQueryContext(open_display(), made->context, EGL_CONTEXT_CLIENT_TYPE, &api);
    eglBindAPI((EGLenum)api);
    return eglMakeCurrent(open_display(), made->surface, made->surface, made->context);
}

static void release(void)
{
    eglMakeCurrent(open_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void destroy(void *native)
{
    egl *made = native;
    if (made->surface != EGL_NO_SURFACE) eglDestroySurface(open_display(), made->surface);
    eglDestroyContext(open_display(), made->context);
    free(made);
}

static void (*get_proc_address(const char *name))(void)
{
    return eglGetProcAddress(name);
}

const test_platform test_platform_egl = {create, make_current, release, destroy, get_proc_address};
