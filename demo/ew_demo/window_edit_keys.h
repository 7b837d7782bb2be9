/*
 * Changing parts of a scene in the window by keys: choosing one and moving its sliders, undo and saving. While the window shows
 * the animation, or its panel is hidden, there is nothing to choose.
 */
#ifndef WINDOW_EDIT_KEYS_H
#define WINDOW_EDIT_KEYS_H

#include "window_state.h"

/* What a key does while Ctrl is down. */
void window_edit_key_with_ctrl(demo_window *window, int key, int scancode, int mods);

/* What a key does that goes down, or that repeats. */
void window_edit_key_down(demo_window *window, int key, int mods);

/* However long a slider's key was down, that is one step to undo. */
void window_edit_key_up(demo_window *window, int key);

#endif
