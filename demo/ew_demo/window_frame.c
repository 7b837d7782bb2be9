/* One frame of the window: see window_frame.h. */
#include "window_frame.h"
#include "files.h"
#include "image.h"
#include "message.h"
#include "panel.h"
#include "window_edit.h"
#include "window_mouse.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A pixel of the map of errors covers this many pixels of the window each way, because its reference is costly. */
enum { ERROR_MAP_PIXEL = 8 };

static const double look_seconds = 0.25;

/* Writes the picture, without the panel, under the first name that is free. */
static void write_screenshot(demo_window *window)
{
    char name[40] = "", message[600];
    int width, height, number = 0;
    display_size(window->display, &width, &height);
    unsigned char *srgb = malloc((size_t)width * (size_t)height * 3);
    do
        snprintf(name, sizeof name, "ew-demo-%03d.png", ++number);
    while (file_exists(name));
    image_pixels picture = {.width = width, .height = height, .channels = 3, .srgb = srgb};
    if (srgb) display_read(window->display, 3, srgb);
    if (!srgb)
        message_write(message, sizeof message, "the picture does not fit into memory; make the window smaller");
    else if (image_write(name, &picture, message, sizeof message))
        message_write(message, sizeof message, "wrote %s", name);
    window_notify(window, message);
    free(srgb);
}

void window_advance(demo_window *window)
{
    double now = glfwGetTime(), passed = now - window->last_time;
    window->last_time = now;
    double share = window->frame_milliseconds > 0 ? 0.1 : 1;
    /* The first frame compiles its shaders, and says nothing of the others. */
    if (window->frames_begun++ > 1) window->frame_milliseconds += share * (1000 * passed - window->frame_milliseconds);
    if (!window->is_paused) window->seconds += passed * window->time_scale;
    window_fly(window, fmin(passed, 0.25));
    if (window->options->scene && now - window->last_look > look_seconds) {
        window->last_look = now;
        if (scene_watch_look(&window->file) && !window->file.message[0]) window_notify(window, "the scene file was read again");
    }
    window_edit_advance(window);
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
        view.statistics[half] = display_statistics_of(window->display, half);
        if (view.statistics[half].map.mean_evaluations < 0)
            view.statistics[half].map.mean_evaluations = window->mean_evaluations[half];
    }
    overlay_begin(window->overlay);
    panel_draw(window->overlay, &view, width, height, (double)scale_y);
    window_edit_draw(window, width, height, (double)scale_y);
    overlay_draw(window->overlay, width, height);
}

bool window_draw(demo_window *window, int width, int height, char *message, size_t size)
{
    const gl_functions *gl = &window->gl;
    demo_scene scene = camera_control_scene(&window->camera, window_scene(window), window->options->scene != NULL);
    int pixel = window->mode == DISPLAY_ERROR ? ERROR_MAP_PIXEL : 1;
    display_view view = {.scene = &scene,
                         .mode = window->mode,
                         .court_look = !window->options->scene,
                         .settings = window->integrators[0],
                         .samples_per_axis = window->options->samples_per_axis,
                         .split = window->split,
                         .right = window->integrators[1]};
    view.settings.width = width / pixel > 0 ? width / pixel : 1;
    view.settings.height = height / pixel > 0 ? height / pixel : 1;
    double now = glfwGetTime();
    view.count_evaluations = window->shows_panel && now - window->last_count > WINDOW_COUNT_SECONDS;
    if (view.count_evaluations) window->last_count = now;
    if (!display_draw(window->display, &view, message, size)) return false;
    for (int half = 0; half < 2; half++) {
        double mean = display_statistics_of(window->display, half).map.mean_evaluations;
        if (mean >= 0) window->mean_evaluations[half] = mean;
    }
    if (window->wants_screenshot) write_screenshot(window);
    window->wants_screenshot = false;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, display_framebuffer(window->display));
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, 0, view.settings.width, view.settings.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    draw_panel(window, width, height);
    window->mode = window->next_mode;
    return true;
}
