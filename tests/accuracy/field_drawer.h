/*
 * Luminance drawn against any depth: for what a scene file cannot say, such as a part of a picture, or rays that end where a
 * test wants them to.
 */
#ifndef FIELD_DRAWER_H
#define FIELD_DRAWER_H

#include "context.h"
#include "render.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct field_drawer {
    const gl_functions *gl;
    int width, height;
    render_target target;
    ew_effect *effect; /* not its own */
} field_drawer;

/* For pictures of the given size, drawn by `effect`, whose sources it replaces at will. On failure returns false, with a
 * message and nothing to destroy. */
bool field_drawer_create(gl_context *context, ew_effect *effect, int width, int height, field_drawer *drawer, char *message,
                         size_t size);
void field_drawer_destroy(field_drawer *drawer);

/* Draws the sources' luminance, or another output, as `frame` says; its target and its depth texture are the drawer's. `depth`
 * is what the depth texture holds. Both have one float a pixel of the drawer's target, rows from the bottom up. */
bool field_drawer_draw(field_drawer *drawer, const ew_sources_desc *sources, const ew_frame_desc *frame, const float *depth,
                       float *output, ew_error *error);

#endif
