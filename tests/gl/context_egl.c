/* Contexts without a surface through EGL. */
#include "context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdio.h>

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

static void *create(const test_context_desc *desc, void *share)
{
    EGLDisplay display = open_display();
    if (display == EGL_NO_DISPLAY) return NULL;
    const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, desc->es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                        0, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count == 0) return NULL;

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
    EGLContext context = eglCreateContext(display, config, share ? share : EGL_NO_CONTEXT, attributes);
    return context == EGL_NO_CONTEXT ? NULL : context;
}

static bool make_current(void *native)
{
    EGLint api = EGL_OPENGL_API;
    eglQueryContext(open_display(), native, EGL_CONTEXT_CLIENT_TYPE, &api);
    eglBindAPI((EGLenum)api);
    return eglMakeCurrent(open_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, native);
}

static void release(void)
{
    eglMakeCurrent(open_display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void destroy(void *native)
{
    eglDestroyContext(open_display(), native);
}

static void (*get_proc_address(const char *name))(void)
{
    return eglGetProcAddress(name);
}

const test_platform test_platform_egl = {create, make_current, release, destroy, get_proc_address};
