/*
 * Changing a scene file's sources and opaque shapes in the window: selecting one by a click on it, and dragging its handles and
 * its sliders. While the window shows the animation, or its panel is hidden, all of this does nothing.
 */
#ifndef WINDOW_EDIT_H
#define WINDOW_EDIT_H

#include "edit_panel.h"
#include "window_state.h"

#include <stdbool.h>

/* Has the document ask the display before it takes a scene. */
void window_edit_begin(demo_window *window);

/* The left button goes down or up at the window's cursor. */
void window_edit_press(demo_window *window);
void window_edit_release(demo_window *window);

/* Whether the cursor holds something, or may still be going to click; the camera then stays. */
bool window_edit_has_cursor(demo_window *window);

/* Whether there is something to change. */
bool window_edit_is_on(const demo_window *window);

/* The panel of the selected part, if there is one. */
edit_panel window_edit_panel(demo_window *window);

/* Lets go of what is not there any more, after the scene may have changed. */
void window_edit_check(demo_window *window);

/* Moves what is held to the cursor, once a frame. */
void window_edit_advance(demo_window *window);

/* Returns false, and says why, at the first attempt to close the window on changes that are not saved. */
bool window_edit_may_close(demo_window *window);

/* Adds the selected part's shape, its handles and its sliders to the overlay. */
void window_edit_draw(demo_window *window, int width, int height, double scale);

#endif
