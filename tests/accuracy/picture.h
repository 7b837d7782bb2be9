/*
 * A scene's luminance as the library draws it, with the depth buffer that it drew against.
 */
#ifndef PICTURE_H
#define PICTURE_H

#include "context.h"
#include "render.h"
#include "scene_file.h"

#include <stdbool.h>
#include <stddef.h>

/* Rows from the bottom up, one float a pixel. */
typedef struct drawn_picture {
    int width;
    int height;
    float *luminance;
    float *depth; /* 0 .. 1, as stored */
} drawn_picture;

/* Draws the scene on `context` by the settings. On failure returns false, with a message and nothing to free. */
bool picture_draw(gl_context *context, const demo_scene *scene, const render_settings *settings, drawn_picture *picture,
                  char *message, size_t size);

void picture_free(drawn_picture *picture);

#endif
