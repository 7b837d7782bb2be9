/*
 * The window's mouse, and the keys that fly.
 */
#ifndef WINDOW_MOUSE_H
#define WINDOW_MOUSE_H

#include "window_state.h"

/* For glfwSetCursorPosCallback, glfwSetMouseButtonCallback and glfwSetScrollCallback; the user pointer is the demo_window. */
void window_on_cursor(GLFWwindow *handle, double x, double y);
void window_on_button(GLFWwindow *handle, int button, int action, int mods);
void window_on_scroll(GLFWwindow *handle, double x, double y);

/* Flies for `seconds` in the directions of the keys that are down. */
void window_fly(demo_window *window, double seconds);

#endif
