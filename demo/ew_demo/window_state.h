/*
 * The window's state, which window.c and the other files of this name share.
 */
#ifndef WINDOW_STATE_H
#define WINDOW_STATE_H

#include "animation.h"
#include "camera_control.h"
#include "display.h"
#include "options.h"
#include "overlay.h"
#include "scene_part.h"
#include "scene_watch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

/* What the left mouse button holds. */
typedef enum edit_grip { GRIP_NONE, GRIP_HANDLE, GRIP_SLIDER, GRIP_PANEL } edit_grip;

/* The part of a scene file that is being changed. */
typedef struct window_edit {
    bool has_selection;
    scene_part selected;
    edit_grip grip;
    size_t handle;       /* which of the part's is held */
    int slider;          /* likewise */
    int chosen_slider;   /* which of the part's the arrow keys change */
    double held_from[3]; /* where the handle was when it was taken */
    double offset[2];    /* from the cursor to the handle then, as places in the picture */
    bool is_click;       /* the button went down, and the cursor has not moved since */
    double pressed[2];
    double warned_until; /* closing the window before this time drops what is not saved */
} window_edit;

typedef struct demo_window {
    GLFWwindow *handle;
    gl_functions gl;
    const demo_options *options;
    demo_display *display;
    demo_overlay *overlay;
    demo_animation *animation;
    scene_watch file; /* only if the options name a scene file */

    double seconds; /* the animation's time */
    double time_scale;
    bool is_paused;
    camera_control camera;
    double cursor[2]; /* in the window's own units, which are larger than pixels on some screens */
    window_edit edit;
    int command_key; /* went down with Ctrl, and does not fly until it is up, though Ctrl may be up before; 0 for none */
    display_mode mode, next_mode; /* of this frame, and from the next one on */
    bool split;
    render_settings integrators[2];
    bool shows_panel, shows_keys, has_vsync;
    int windowed[4]; /* x, y, width and height outside the full screen */

    int frames_begun;
    double frame_milliseconds; /* mean of the last frames; 0 before there were any */
    double last_time;          /* when the last frame began, by GLFW's clock */
    double last_look;          /* when the scene file was last looked at */
    double last_count;         /* when evaluations were last counted */
    double mean_evaluations[2];
    char notice[600];
    double notice_until;
    bool wants_screenshot; /* of the next picture, which shows the effect of all keys so far */
} demo_window;

/* The scene of the file or of the animation, with its own camera. */
static inline const demo_scene *window_scene(const demo_window *window)
{
    return window->options->scene ? &window->file.document.scene : &window->animation->scene;
}

/* Shows a line of text for a few seconds. */
void window_notify(demo_window *window, const char *text);

/* Shows a picture or a map from the next frame on. A map of errors takes long, which this frame says. */
void window_show(demo_window *window, display_mode mode);

#endif
