/*
 * ew-demo's command line.
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "context.h"
#include "display.h"
#include "render.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_options {
    const char *scene; /* a scene file; NULL for the animation */
    bool flight;       /* of the animation's camera */
    bool offscreen;
    int first_frame; /* the animation begins with frame 0 */
    int last_frame;  /* included */
    bool has_frames; /* whether they were asked for */
    int frames_per_second;
    const char *output; /* a printf format of pictures' names, for the frame's number; NULL for none */
    const char *video;  /* NULL for none */
    render_settings settings;
    bool split;
    render_settings right; /* how to integrate the right half */
    display_mode mode;
    int samples_per_axis;
    context_backend backend;
} demo_options;

/* Returns false with a message, or with an empty one where the options asked for a text that has been printed. */
bool options_read(int argc, char **argv, demo_options *options, char *message, size_t size);

#endif
