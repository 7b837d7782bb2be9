/* The demo in a window: see window.h. */
#include "window.h"
#include "animation.h"
#include "camera_control.h"
#include "image.h"
#include "message.h"
#include "overlay.h"
#include "panel.h"
#include "scene_watch.h"
#include "stage.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* How many pixels of the window a pixel of the map of errors covers: its reference is costly. */
enum { ERROR_MAP_PIXEL = 8 };

static const double notice_seconds = 4, look_seconds = 0.25, count_seconds = 0.5;

typedef struct demo_window {
    GLFWwindow *handle;
    gl_functions gl;
    const demo_options *options;
    demo_stage *stage;
    demo_overlay *overlay;
    demo_animation *animation;
    scene_watch file; /* if the options name one */

    double seconds; /* of the animation */
    double time_scale;
    bool is_paused;
    camera_control camera;
    double cursor[2];
    stage_mode mode;
    bool split;
    render_settings integrators[2];
    bool shows_panel, shows_keys, has_vsync;
    int windowed[4]; /* where the window goes back to from the full screen */

    double frame_milliseconds; /* a mean of the last ones */
    double last_time;          /* by the clock, of the last frame, ... */
    double last_look;          /* ... look at the file */
    double last_count;         /* ... and count of evaluations */
    double mean_evaluations[2];
    char notice[600];
    double notice_until;
    bool wants_screenshot;
} demo_window;

/* The last thing that GLFW said. */
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

static void notify(demo_window *window, const char *text)
{
    message_write(window->notice, sizeof window->notice, "%s", text);
    window->notice_until = glfwGetTime() + notice_seconds;
}

static const demo_scene *scene_of(const demo_window *window)
{
    return window->options->scene ? &window->file.scene : &window->animation->scene;
}

/* ---- What the keys do ---------------------------------------------------------------------------------------------------- */

static void toggle_pause(demo_window *window)
{
    window->is_paused = !window->is_paused;
}

/* To the next frame of a recording. */
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
    window->mode = (stage_mode)((window->mode + 1) % 3);
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
        notify(window, "no monitor is known to fill");
        return;
    }
    glfwGetWindowPos(window->handle, &place[0], &place[1]);
    glfwGetWindowSize(window->handle, &place[2], &place[3]);
    glfwSetWindowMonitor(window->handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

/* The keys from 1 on; with Shift, of the right half. */
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
    window->integrators[is_right] = integrators[number];
    if (is_right) window->split = true;
}

/* Writes the picture, without what stands over it, under the first name that is free. */
static void write_screenshot(demo_window *window)
{
    char name[40] = "", message[600];
    int width, height, number = 0;
    stage_size(window->stage, &width, &height);
    unsigned char *srgb = malloc((size_t)width * (size_t)height * 3);
    do
        snprintf(name, sizeof name, "ew-demo-%03d.png", ++number);
    while (access(name, F_OK) == 0);
    image_pixels picture = {.width = width, .height = height, .channels = 3, .srgb = srgb};
    if (srgb) stage_read(window->stage, srgb);
    if (!srgb)
        message_write(message, sizeof message, "the picture does not fit into memory; make the window smaller");
    else if (image_write(name, &picture, message, sizeof message))
        message_write(message, sizeof message, "%s is written", name);
    notify(window, message);
    free(srgb);
}

/* Of the next picture, which all keys before this one have had their effect on. */
static void take_screenshot(demo_window *window)
{
    window->wants_screenshot = true;
}

static void close_window(demo_window *window)
{
    glfwSetWindowShouldClose(window->handle, GLFW_TRUE);
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

/* ---- Keyboard and mouse -------------------------------------------------------------------------------------------------- */

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int mods)
{
    (void)scancode;
    demo_window *window = glfwGetWindowUserPointer(handle);
    /* Held down, only the keys that step go on. */
    if (action == GLFW_RELEASE || (action == GLFW_REPEAT && key != GLFW_KEY_PERIOD && key != GLFW_KEY_COMMA)) return;
    if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + INTEGRATOR_COUNT)
        set_integrator(window, key - GLFW_KEY_1, (mods & GLFW_MOD_SHIFT) != 0);
    for (size_t i = 0; i < sizeof actions / sizeof *actions; i++)
        if (actions[i].key == key) actions[i].act(window);
}

static bool is_down(const demo_window *window, int key)
{
    return glfwGetKey(window->handle, key) == GLFW_PRESS;
}

static void on_cursor(GLFWwindow *handle, double x, double y)
{
    demo_window *window = glfwGetWindowUserPointer(handle);
    const double degrees_a_pixel = 0.25;
    double right = degrees_a_pixel * (x - window->cursor[0]), down = degrees_a_pixel * (y - window->cursor[1]);
    window->cursor[0] = x;
    window->cursor[1] = y;
    if (glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS)
        camera_control_orbit(&window->camera, scene_of(window), -right, down);
    else if (glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS)
        camera_control_look(&window->camera, scene_of(window), right, -down);
}

static void on_scroll(GLFWwindow *handle, double x, double y)
{
    (void)x;
    demo_window *window = glfwGetWindowUserPointer(handle);
    camera_control_approach(&window->camera, scene_of(window), pow(1.1, y));
}

/* As far as the keys that are held down take it in `seconds`: some part of the distance to what the scene's camera sees. */
static void fly(demo_window *window, double seconds)
{
    static const int keys[3][2] = {{GLFW_KEY_A, GLFW_KEY_D}, {GLFW_KEY_Q, GLFW_KEY_E}, {GLFW_KEY_S, GLFW_KEY_W}};
    const scene_camera *camera = &scene_of(window)->camera;
    double sight = 0, way[3];
    for (int i = 0; i < 3; i++)
        sight += (camera->target[i] - camera->eye[i]) * (camera->target[i] - camera->eye[i]);
    double speed = sqrt(sight) * (is_down(window, GLFW_KEY_LEFT_SHIFT) ? 1.2 : 0.3);
    bool moves = false;
    for (int i = 0; i < 3; i++) {
        way[i] = speed * seconds * (is_down(window, keys[i][1]) - is_down(window, keys[i][0]));
        moves = moves || way[i] != 0;
    }
    if (moves) camera_control_fly(&window->camera, scene_of(window), way);
}

/* ---- Frames -------------------------------------------------------------------------------------------------------------- */

/* The clock moves the animation on, and everything else that goes by it. */
static void advance(demo_window *window)
{
    double now = glfwGetTime(), passed = now - window->last_time;
    window->last_time = now;
    double share = window->frame_milliseconds > 1 ? 0.1 : 1;
    window->frame_milliseconds += share * (1000 * passed - window->frame_milliseconds);
    if (!window->is_paused) window->seconds += passed * window->time_scale;
    fly(window, fmin(passed, 0.25));
    if (window->options->scene && now - window->last_look > look_seconds) {
        window->last_look = now;
        if (scene_watch_look(&window->file) && !window->file.message[0]) notify(window, "the scene is read again");
    }
    animation_set_time(window->animation, window->seconds);
}

static void draw_panel(demo_window *window, int width, int height)
{
    float scale_x, scale_y;
    glfwGetWindowContentScale(window->handle, &scale_x, &scale_y);
    panel_view view = {.scene_name = window->options->scene ? window->options->scene : "court",
                       .gl_name = (const char *)window->gl.GetString(GL_RENDERER),
                       .seconds = window->seconds,
                       .frames_per_second = window->options->frames_per_second,
                       .time_scale = window->time_scale,
                       .is_paused = window->is_paused,
                       .is_animated = !window->options->scene,
                       .frame_milliseconds = window->frame_milliseconds,
                       .mode = window->mode,
                       .split = window->split,
                       .integrators = {window->integrators[0], window->integrators[1]},
                       .shows_keys = window->shows_keys,
                       .shows_panel = window->shows_panel,
                       .notice = glfwGetTime() < window->notice_until ? window->notice : "",
                       .error = window->options->scene ? window->file.message : ""};
    for (int half = 0; half < 2; half++) {
        view.statistics[half] = stage_statistics_of(window->stage, half);
        if (view.statistics[half].map.mean_evaluations < 0)
            view.statistics[half].map.mean_evaluations = window->mean_evaluations[half];
    }
    panel_draw(window->overlay, &view, width, height, (double)scale_y);
}

static bool draw(demo_window *window, int width, int height, char *message, size_t size)
{
    const gl_functions *gl = &window->gl;
    demo_scene scene = camera_control_scene(&window->camera, scene_of(window), window->options->scene != NULL);
    int pixel = window->mode == STAGE_ERROR ? ERROR_MAP_PIXEL : 1;
    stage_view view = {.scene = &scene,
                       .mode = window->mode,
                       .lit = !window->options->scene,
                       .settings = window->integrators[0],
                       .samples_per_axis = window->options->samples_per_axis,
                       .split = window->split,
                       .right = window->integrators[1]};
    view.settings.width = width / pixel > 0 ? width / pixel : 1;
    view.settings.height = height / pixel > 0 ? height / pixel : 1;
    double now = glfwGetTime();
    view.count_evaluations = window->shows_panel && now - window->last_count > count_seconds;
    if (view.count_evaluations) window->last_count = now;
    if (!stage_draw(window->stage, &view, message, size)) return false;
    for (int half = 0; half < 2; half++) {
        double mean = stage_statistics_of(window->stage, half).map.mean_evaluations;
        if (mean >= 0) window->mean_evaluations[half] = mean;
    }
    if (window->wants_screenshot) write_screenshot(window);
    window->wants_screenshot = false;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, stage_framebuffer(window->stage));
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, 0, view.settings.width, view.settings.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    draw_panel(window, width, height);
    return true;
}

static bool loop(demo_window *window, char *message, size_t size)
{
    window->last_time = glfwGetTime();
    while (!glfwWindowShouldClose(window->handle)) {
        int width, height;
        glfwPollEvents();
        glfwGetFramebufferSize(window->handle, &width, &height);
        /* Nothing can be drawn for a minimised window, and nothing needs to be. */
        if (width <= 0 || height <= 0 || glfwGetWindowAttrib(window->handle, GLFW_ICONIFIED)) {
            glfwWaitEventsTimeout(0.25);
            window->last_time = glfwGetTime();
            continue;
        }
        advance(window);
        if (!draw(window, width, height, message, size)) return false;
        glfwSwapBuffers(window->handle);
    }
    return true;
}

/* ---- Beginning and end --------------------------------------------------------------------------------------------------- */

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

static bool begin(demo_window *window, char *message, size_t size)
{
    ew_effect_desc desc = {.get_proc_address = get_proc_address};
    window->animation = malloc(sizeof *window->animation);
    if (!window->animation) {
        message_write(message, size, "memory is exhausted; close other programs");
        return false;
    }
    animation_init(window->animation);
    if (!open_window(window, message, size)) return false;
    window->stage = stage_create(&window->gl, &desc, message, size);
    window->overlay = window->stage ? overlay_create(&window->gl, message, size) : NULL;
    if (!window->overlay) return false;
    glfwSetWindowUserPointer(window->handle, window);
    glfwSetKeyCallback(window->handle, on_key);
    glfwSetCursorPosCallback(window->handle, on_cursor);
    glfwSetScrollCallback(window->handle, on_scroll);
    glfwSwapInterval(window->has_vsync);
    return true;
}

static void end(demo_window *window)
{
    overlay_destroy(window->overlay);
    stage_destroy(window->stage);
    free(window->animation);
    if (window->handle) glfwDestroyWindow(window->handle);
    glfwTerminate();
}

bool window_run(const demo_options *options, char *message, size_t size)
{
    demo_window window = {.options = options, .time_scale = 1, .shows_panel = true, .has_vsync = true, .split = options->split};
    window.integrators[0] = options->settings;
    window.integrators[1] = options->right;
    window.mode = options->mode;
    window.last_count = -count_seconds;
    if (options->scene && !scene_watch_begin(&window.file, options->scene)) {
        message_write(message, size, "%s", window.file.message);
        return false;
    }
    bool ok = begin(&window, message, size) && loop(&window, message, size);
    end(&window);
    if (options->scene) scene_watch_end(&window.file);
    return ok;
}
