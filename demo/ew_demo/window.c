/* The demo in a window: see window.h. */
#include "window.h"
#include "message.h"
#include "window_edit.h"
#include "window_frame.h"
#include "window_keys.h"
#include "window_mouse.h"

#include <stdlib.h>

static const double notice_seconds = 4;

/* GLFW's last error. */
static char glfw_message[300];

static void keep_glfw_message(int code, const char *text)
{
    (void)code;
    message_write(glfw_message, sizeof glfw_message, "%s", text);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return glfwGetProcAddress(name);
}

void window_notify(demo_window *window, const char *text)
{
    message_write(window->notice, sizeof window->notice, "%s", text);
    window->notice_until = glfwGetTime() + notice_seconds;
}

void window_show(demo_window *window, display_mode mode)
{
    window->next_mode = mode;
    if (mode == DISPLAY_ERROR) window_notify(window, "computing the map of errors, which takes some seconds");
}

static bool loop(demo_window *window, char *message, size_t size)
{
    window->last_time = glfwGetTime();
    while (!glfwWindowShouldClose(window->handle)) {
        int width, height;
        glfwPollEvents();
        glfwGetFramebufferSize(window->handle, &width, &height);
        /* A minimised window has no pixels to draw. */
        if (width <= 0 || height <= 0 || glfwGetWindowAttrib(window->handle, GLFW_ICONIFIED)) {
            glfwWaitEventsTimeout(0.25);
            window->last_time = glfwGetTime();
            continue;
        }
        window_advance(window);
        if (!window_draw(window, width, height, message, size)) return false;
        glfwSwapBuffers(window->handle);
    }
    return true;
}

static bool open_window(demo_window *window, char *message, size_t size)
{
    const demo_options *options = window->options;
    glfwSetErrorCallback(keep_glfw_message);
    if (!glfwInit()) {
        message_write(message, size, "no display (%s); run it on a desktop, or add --offscreen -o frames/%%05d.png",
                      glfw_message);
        return false;
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window->handle = glfwCreateWindow(options->settings.width, options->settings.height, "EnergyWave", NULL, NULL);
    if (!window->handle) {
        message_write(message, size,
                      "no OpenGL 3.3 core context (%s); install a GL driver (on Debian libgl1-mesa-dri), or add "
                      "--offscreen -o frames/%%05d.png",
                      glfw_message);
        return false;
    }
    glfwMakeContextCurrent(window->handle);
    const char *missing = gl_load_functions(&window->gl, get_proc_address, NULL);
    if (missing) message_write(message, size, "this OpenGL has no %s; update the GL driver", missing);
    return !missing;
}

static void on_close(GLFWwindow *handle)
{
    demo_window *window = glfwGetWindowUserPointer(handle);
    glfwSetWindowShouldClose(handle, window_edit_may_close(window));
}

static bool begin(demo_window *window, char *message, size_t size)
{
    ew_effect_desc desc = {.get_proc_address = get_proc_address};
    window->animation = malloc(sizeof *window->animation);
    if (!window->animation) {
        message_write(message, size, "memory is exhausted; close other programs");
        return false;
    }
    animation_init(window->animation);
    window->animation->flies = window->options->flight;
    if (!open_window(window, message, size)) return false;
    window->display = display_create(&window->gl, &desc, message, size);
    window->overlay = window->display ? overlay_create(&window->gl, message, size) : NULL;
    if (!window->overlay) return false;
    glfwSetWindowUserPointer(window->handle, window);
    glfwGetCursorPos(window->handle, &window->cursor[0], &window->cursor[1]);
    window_edit_begin(window);
    glfwSetWindowCloseCallback(window->handle, on_close);
    glfwSetKeyCallback(window->handle, window_on_key);
    glfwSetCursorPosCallback(window->handle, window_on_cursor);
    glfwSetMouseButtonCallback(window->handle, window_on_button);
    glfwSetScrollCallback(window->handle, window_on_scroll);
    glfwSwapInterval(window->has_vsync);
    window_show(window, window->options->mode);
    return true;
}

static void end(demo_window *window)
{
    overlay_destroy(window->overlay);
    display_destroy(window->display);
    free(window->animation);
    if (window->handle) glfwDestroyWindow(window->handle);
    glfwTerminate();
}

bool window_run(const demo_options *options, char *message, size_t size)
{
    demo_window window = {.options = options, .time_scale = 1, .shows_panel = true, .has_vsync = true, .split = options->split};
    window.integrators[0] = options->settings;
    window.integrators[1] = options->right;
    /* A map of errors is announced first. */
    window.mode = window.next_mode = options->mode == DISPLAY_ERROR ? DISPLAY_PICTURE : options->mode;
    window.last_count = -WINDOW_COUNT_SECONDS;
    if (options->scene && !scene_watch_begin(&window.file, options->scene)) {
        message_write(message, size, "%s", window.file.message);
        return false;
    }
    bool ok = begin(&window, message, size) && loop(&window, message, size);
    end(&window);
    if (options->scene) scene_watch_end(&window.file);
    return ok;
}
