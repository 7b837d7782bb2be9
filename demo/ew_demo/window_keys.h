/*
 * What the window's keys do, except for those that fly.
 */
#ifndef WINDOW_KEYS_H
#define WINDOW_KEYS_H

#include "window_state.h"

/* For glfwSetKeyCallback; the user pointer is the demo_window. */
void window_on_key(GLFWwindow *handle, int key, int scancode, int action, int mods);

#endif
