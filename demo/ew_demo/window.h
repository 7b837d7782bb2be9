/*
 * The demo in a window.
 */
#ifndef WINDOW_H
#define WINDOW_H

#include "options.h"

/* Shows the options' scene file or the animation until the window is closed. On failure returns false, with a message. */
bool window_run(const demo_options *options, char *message, size_t size);

#endif
