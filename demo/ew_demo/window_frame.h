/*
 * One frame of the window.
 */
#ifndef WINDOW_FRAME_H
#define WINDOW_FRAME_H

#include "window_state.h"

#include <stdbool.h>
#include <stddef.h>

/* Evaluations are counted anew after this time. */
#define WINDOW_COUNT_SECONDS 0.5

/* Brings everything up to the present: the animation, the flight, and the scene file. */
void window_advance(demo_window *window);

/* Draws the picture and the panel into framebuffer 0, of the given size. On failure returns false, with a message. */
bool window_draw(demo_window *window, int width, int height, char *message, size_t size);

#endif
