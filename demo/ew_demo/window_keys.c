/* What the window's keys do: see window_keys.h. */
#include "window_keys.h"
#include "window_edit.h"
#include "window_edit_keys.h"

#include <math.h>

static void toggle_pause(demo_window *window)
{
    window->is_paused = !window->is_paused;
}

/* Goes to a frame that --offscreen would draw. */
static void step(demo_window *window, int frames)
{
    int fps = window->options->frames_per_second;
    window->is_paused = true;
    window->seconds = (round(window->seconds * fps) + frames) / fps;
}

static void step_forward(demo_window *window)
{
    step(window, 1);
}

static void step_back(demo_window *window)
{
    step(window, -1);
}

static void go_slower(demo_window *window)
{
    window->time_scale = fmax(window->time_scale / 2, 1.0 / 64);
}

static void go_faster(demo_window *window)
{
    window->time_scale = fmin(window->time_scale * 2, 8);
}

static void reset(demo_window *window)
{
    window->seconds = 0;
    window->time_scale = 1;
    window->camera.is_free = false;
}

static void release_camera(demo_window *window)
{
    window->camera.is_free = false;
}

static void toggle_split(demo_window *window)
{
    window->split = !window->split;
}

static void next_map(demo_window *window)
{
    window_show(window, (display_mode)((window->next_mode + 1) % 3));
}

static void toggle_keys(demo_window *window)
{
    window->shows_keys = !window->shows_keys;
}

static void toggle_panel(demo_window *window)
{
    window->shows_panel = !window->shows_panel;
}

static void toggle_vsync(demo_window *window)
{
    window->has_vsync = !window->has_vsync;
    glfwSwapInterval(window->has_vsync);
}

static void toggle_full_screen(demo_window *window)
{
    int *place = window->windowed;
    if (glfwGetWindowMonitor(window->handle)) {
        glfwSetWindowMonitor(window->handle, NULL, place[0], place[1], place[2], place[3], GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (!mode) {
        window_notify(window, "no monitor was found");
        return;
    }
    glfwGetWindowPos(window->handle, &place[0], &place[1]);
    glfwGetWindowSize(window->handle, &place[2], &place[3]);
    glfwSetWindowMonitor(window->handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

/* What the keys from 1 on select; with Shift, for the right half. */
static const render_settings integrators[] = {
    {.integrator = EW_INTEGRATOR_ADAPTIVE, .quality = EW_QUALITY_ERROR_1E_2},
    {.integrator = EW_INTEGRATOR_ADAPTIVE, .quality = EW_QUALITY_ERROR_1E_3},
    {.integrator = EW_INTEGRATOR_ADAPTIVE, .quality = EW_QUALITY_ERROR_1E_4},
    {.integrator = EW_INTEGRATOR_SIMPSON, .simpson_divisions = 64},
    {.integrator = EW_INTEGRATOR_SIMPSON, .simpson_divisions = 128},
    {.integrator = EW_INTEGRATOR_SIMPSON, .simpson_divisions = 256},
};
enum { INTEGRATOR_COUNT = sizeof integrators / sizeof *integrators };

static void set_integrator(demo_window *window, int number, bool is_right)
{
    ew_resolution resolution = window->integrators[is_right].resolution;
    window->integrators[is_right] = integrators[number];
    window->integrators[is_right].resolution = resolution;
    if (is_right) window->split = true;
}

static void take_screenshot(demo_window *window)
{
    window->wants_screenshot = true;
}

static void close_window(demo_window *window)
{
    glfwSetWindowShouldClose(window->handle, window_edit_may_close(window));
}

static const struct {
    int key;
    void (*act)(demo_window *window);
} actions[] = {
    {GLFW_KEY_SPACE, toggle_pause},     {GLFW_KEY_PERIOD, step_forward},     {GLFW_KEY_COMMA, step_back},
    {GLFW_KEY_LEFT_BRACKET, go_slower}, {GLFW_KEY_RIGHT_BRACKET, go_faster}, {GLFW_KEY_R, reset},
    {GLFW_KEY_C, release_camera},       {GLFW_KEY_TAB, toggle_split},        {GLFW_KEY_M, next_map},
    {GLFW_KEY_H, toggle_keys},          {GLFW_KEY_P, toggle_panel},          {GLFW_KEY_V, toggle_vsync},
    {GLFW_KEY_F11, toggle_full_screen}, {GLFW_KEY_F12, take_screenshot},     {GLFW_KEY_ESCAPE, close_window},
};

void window_on_key(GLFWwindow *handle, int key, int scancode, int action, int mods)
{
    demo_window *window = glfwGetWindowUserPointer(handle);
    if (action == GLFW_RELEASE && key == window->command_key) window->command_key = 0;
    if (action != GLFW_RELEASE && mods & GLFW_MOD_CONTROL) {
        window->command_key = key;
        window_edit_key_with_ctrl(window, key, scancode, mods);
        return;
    }
    if (action == GLFW_RELEASE)
        window_edit_key_up(window, key);
    else
        window_edit_key_down(window, key, mods);
    /* Of the keys that are held down, only those that step repeat. */
    if (action == GLFW_RELEASE || (action == GLFW_REPEAT && key != GLFW_KEY_PERIOD && key != GLFW_KEY_COMMA)) return;
    if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + INTEGRATOR_COUNT)
        set_integrator(window, key - GLFW_KEY_1, (mods & GLFW_MOD_SHIFT) != 0);
    for (size_t i = 0; i < sizeof actions / sizeof *actions; i++)
        if (actions[i].key == key) actions[i].act(window);
}
