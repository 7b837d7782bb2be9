/*
 * A game's window by Win32 and WGL alone, drawn to by the DLL: there is light, the window's own depth hides it, it stays in the
 * middle when the window is resized, and GL's state stays as it was.
 */
#include <energywave.h>

#include <windows.h>

#include <GL/gl.h>
#include <GL/wglext.h>

#include <stdio.h>
#include <stdlib.h>

static void check(int ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "windowed_host: %s\n", what);
    exit(EXIT_FAILURE);
}

/* WGL knows only what OpenGL 1.1 does not have, and the library opengl32 only the rest. */
static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    PROC function = wglGetProcAddress(name);
    if (!function) function = GetProcAddress(GetModuleHandleA("opengl32.dll"), name);
    return (ew_gl_function)function;
}

static void dispatch_messages(void)
{
    MSG message;
    while (PeekMessageA(&message, NULL, 0, 0, PM_REMOVE)) {
        TranslateMessage(&message);
        DispatchMessageA(&message);
    }
}

static HWND open_window(int width, int height)
{
    const WNDCLASSA class = {.style = CS_OWNDC,
                             .lpfnWndProc = DefWindowProcA,
                             .hInstance = GetModuleHandleA(NULL),
                             .lpszClassName = "windowed_host"};
    check(RegisterClassA(&class) != 0, "the window's class is refused");
    HWND window = CreateWindowA("windowed_host", "EnergyWave", WS_POPUP | WS_VISIBLE, 0, 0, width, height, NULL, NULL,
                                class.hInstance, NULL);
    check(window != NULL, "the window is refused");
    dispatch_messages();
    return window;
}

static HGLRC make_context(HDC device)
{
    const PIXELFORMATDESCRIPTOR format = {.nSize = sizeof format,
                                          .nVersion = 1,
                                          .dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER,
                                          .iPixelType = PFD_TYPE_RGBA,
                                          .cColorBits = 24,
                                          .cDepthBits = 24};
    check(SetPixelFormat(device, ChoosePixelFormat(device, &format), &format), "no pixel format");
    HGLRC first = wglCreateContext(device);
    check(first && wglMakeCurrent(device, first), "no OpenGL");
    PFNWGLCREATECONTEXTATTRIBSARBPROC create_context =
        (PFNWGLCREATECONTEXTATTRIBSARBPROC)get_proc_address(NULL, "wglCreateContextAttribsARB");
    check(create_context != NULL, "wglCreateContextAttribsARB is missing");
    const int attributes[] = {
        WGL_CONTEXT_MAJOR_VERSION_ARB,    3, WGL_CONTEXT_MINOR_VERSION_ARB, 3, WGL_CONTEXT_PROFILE_MASK_ARB,
        WGL_CONTEXT_CORE_PROFILE_BIT_ARB, 0};
    HGLRC context = create_context(device, NULL, attributes);
    check(context && wglMakeCurrent(device, context), "no OpenGL 3.3 core");
    wglDeleteContext(first);
    return context;
}

/* What a game has drawn: nothing but a wall, right before the eye, over the left quarter of the window. */
static void draw_opaque_scene(int width, int height)
{
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 1);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, width / 4, height);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

static int blue_at(int x, int y)
{
    unsigned char pixel[4];
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    return pixel[2];
}

static void draw_frame(ew_effect *effect, HDC device, int width, int height)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    ew_error error;
    frame.view[14] = -4;
    frame.projection[0] = (double)height / width;
    frame.viewport_width = width;
    frame.viewport_height = height;
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    frame.output = EW_OUTPUT_SOFT;
    draw_opaque_scene(width, height);
    glEnable(GL_DEPTH_TEST);
    check(ew_draw(effect, &frame, &error) == EW_OK, error.text);
    check(glIsEnabled(GL_DEPTH_TEST) && !glIsEnabled(GL_BLEND), "GL's state has changed");
    check(glGetError() == GL_NO_ERROR, "GL reports an error");

    int center = blue_at(width / 2, height / 2), left = blue_at(3 * width / 8, height / 2),
        right = blue_at(5 * width / 8, height / 2);
    int hidden = blue_at(width / 4 - 2, height / 2), seen = blue_at(width - width / 4 + 1, height / 2);
    printf("%d x %d: %d in the middle, %d and %d beside it, %d behind the wall, %d opposite\n", width, height, center, left,
           right, hidden, seen);
    check(center > 200, "there is no light in the middle");
    check(abs(left - right) <= 4 && left > 10, "the light is not in the middle");
    check(hidden == 0 && seen > 0, "the wall does not hide the light behind it");
    SwapBuffers(device);
    dispatch_messages();
}

int main(void)
{
    ew_effect *effect;
    ew_error error;
    HWND window = open_window(320, 200);
    HDC device = GetDC(window);
    HGLRC context = make_context(device);
    printf("%s, %s\n", (const char *)glGetString(GL_RENDERER), (const char *)glGetString(GL_VERSION));

    check(ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK, error.text);
    const ew_point orb = {.core = 0.3, .reach = 3.5, .brightness = 3, .color = {0.2, 0.5, 1}};
    check(ew_set_sources(effect, &(ew_sources_desc){.points = &orb, .point_count = 1}, &error) == EW_OK, error.text);
    draw_frame(effect, device, 320, 200);
    draw_frame(effect, device, 320, 200);
    check(MoveWindow(window, 0, 0, 200, 240, TRUE), "the window cannot be resized");
    dispatch_messages();
    draw_frame(effect, device, 200, 240);

    ew_destroy_effect(effect);
    wglMakeCurrent(NULL, NULL);
    wglDeleteContext(context);
    DestroyWindow(window);
    return EXIT_SUCCESS;
}
