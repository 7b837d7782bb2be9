/*
 * Contexts by WGL, each with a window that is never shown.
 */
#include "context_backend.h"
#include "message.h"

#include <windows.h>

#include <GL/wglext.h>

#include <stdlib.h>

typedef struct wgl_state {
    HWND window;
    HDC device;
    HGLRC context;
} wgl_state;

static bool make_current(void *user)
{
    wgl_state *state = user;
    return wglMakeCurrent(state->device, state->context);
}

static void release(void *user)
{
    (void)user;
    wglMakeCurrent(NULL, NULL);
}

static void destroy(void *user)
{
    wgl_state *state = user;
    if (state->context) wglDeleteContext(state->context);
    if (state->window) DestroyWindow(state->window); /* and its device with it, since the window's class owns that */
    free(state);
}

/* WGL knows only what OpenGL 1.1 does not have, and the library opengl32 only the rest. */
static ew_gl_function get_proc_address(const char *name)
{
    PROC function = wglGetProcAddress(name);
    if (!function) function = GetProcAddress(GetModuleHandleA("opengl32.dll"), name);
    return (ew_gl_function)function;
}

static HWND create_window(int width, int height)
{
    static const char class_name[] = "energywave hidden";
    HINSTANCE program = GetModuleHandleA(NULL);
    const WNDCLASSA class = {
        .style = CS_OWNDC, .lpfnWndProc = DefWindowProcA, .hInstance = program, .lpszClassName = class_name};
    RegisterClassA(&class); /* fails where it is registered already */
    return CreateWindowA(class_name, "", WS_POPUP, 0, 0, width, height, NULL, NULL, program, NULL);
}

static bool choose_pixel_format(HDC device)
{
    const PIXELFORMATDESCRIPTOR wanted = {.nSize = sizeof wanted,
                                          .nVersion = 1,
                                          .dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER,
                                          .iPixelType = PFD_TYPE_RGBA,
                                          .cColorBits = 24,
                                          .cAlphaBits = 8,
                                          .cDepthBits = 24,
                                          .cStencilBits = 8};
    int format = ChoosePixelFormat(device, &wanted);
    return format != 0 && SetPixelFormat(device, format, &wanted);
}

static HGLRC create_context(HDC device, HGLRC share, const context_desc *desc)
{
    /* The function that takes a version is only known while a context is current. */
    HGLRC first = wglCreateContext(device);
    if (!first || !wglMakeCurrent(device, first)) return first;
    PFNWGLCREATECONTEXTATTRIBSARBPROC create =
        (PFNWGLCREATECONTEXTATTRIBSARBPROC)(void (*)(void))wglGetProcAddress("wglCreateContextAttribsARB");
    const int attributes[] = {WGL_CONTEXT_MAJOR_VERSION_ARB,
                              desc->major,
                              WGL_CONTEXT_MINOR_VERSION_ARB,
                              desc->minor,
                              WGL_CONTEXT_PROFILE_MASK_ARB,
                              desc->compatibility ? WGL_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB
                                                  : WGL_CONTEXT_CORE_PROFILE_BIT_ARB,
                              WGL_CONTEXT_FLAGS_ARB,
                              desc->debug ? WGL_CONTEXT_DEBUG_BIT_ARB : 0,
                              0};
    HGLRC context = create ? create(device, share, attributes) : NULL;
    wglMakeCurrent(NULL, NULL);
    wglDeleteContext(first);
    return context;
}

/* Creates the state's objects and makes the context current; returns what failed, or NULL. */
static const char *create_objects(const context_desc *desc, const wgl_state *share, wgl_state *state)
{
    state->window =
        create_window(desc->window_width > 0 ? desc->window_width : 1, desc->window_height > 0 ? desc->window_height : 1);
    state->device = state->window ? GetDC(state->window) : NULL;
    if (!state->device) return "no window could be made";
    if (!choose_pixel_format(state->device)) return "no pixel format for OpenGL";
    state->context = create_context(state->device, share ? share->context : NULL, desc);
    if (!state->context) return "the driver refused the context";
    return make_current(state) ? NULL : "the context could not be made current";
}

bool context_create_wgl(const context_desc *desc, void *share, context_implementation *implementation, char *message,
                        size_t size)
{
    wgl_state *state = calloc(1, sizeof *state);
    *implementation = (context_implementation){.name = "WGL",
                                               .state = state,
                                               .make_current = make_current,
                                               .release = release,
                                               .get_proc_address = get_proc_address,
                                               .destroy = destroy};
    const char *failure = !state     ? "memory is exhausted"
                          : desc->es ? "there is no OpenGL ES"
                                     : create_objects(desc, share, state);
    if (!failure) return true;
    if (state) destroy(state);
    message_write(message, size, "WGL: %s", failure);
    return false;
}
