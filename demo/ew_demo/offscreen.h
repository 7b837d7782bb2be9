/*
 * Frames as pictures or a video, without a window.
 */
#ifndef OFFSCREEN_H
#define OFFSCREEN_H

#include "options.h"

/* Draws and writes the frames that the options ask for. On failure returns false, with a message; earlier frames have been
 * written. */
bool offscreen_run(const demo_options *options, char *message, size_t size);

#endif
