/*
 * Text and bars over the picture.
 */
#ifndef OVERLAY_H
#define OVERLAY_H

#include "gl_functions.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_overlay demo_overlay;

/* The height of a line of text at scale 1. */
enum { OVERLAY_LINE = 12 };

/* NULL, with a message, on failure. */
demo_overlay *overlay_create(const gl_functions *gl, char *message, size_t size);

/* What follows is collected; places are in pixels from the upper left corner, colours 8-bit sRGB and opacity. What finds no
 * more room is left out. */
void overlay_begin(demo_overlay *overlay);
void overlay_box(demo_overlay *overlay, double x, double y, double width, double height, const unsigned char color[4]);

/* ASCII, with newlines, `scale` times as large as the font is made. */
void overlay_text(demo_overlay *overlay, double x, double y, double scale, const char *text, const unsigned char color[4]);

/* How wide the text's widest line is. */
double overlay_text_width(const char *text, double scale);

/* Draws all that was collected over the bound framebuffer, `width` x `height` pixels. */
void overlay_draw(demo_overlay *overlay, int width, int height);

/* `overlay` may be NULL. */
void overlay_destroy(demo_overlay *overlay);

#endif
