/*
 * Text, boxes and lines over the picture.
 */
#ifndef OVERLAY_H
#define OVERLAY_H

#include "gl_functions.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_overlay demo_overlay;

/* The height of a line of text at scale 1. */
enum { OVERLAY_LINE = 12 };

/* Returns NULL, with a message, on failure. */
demo_overlay *overlay_create(const gl_functions *gl, char *message, size_t size);

/* Begins anew. What is drawn is collected until overlay_draw; when there is no more room, they are left out. */
void overlay_begin(demo_overlay *overlay);

/* Positions and sizes are in pixels, from the upper left corner. Colours are 8-bit sRGB and opacity. */
void overlay_box(demo_overlay *overlay, double x, double y, double width, double height, const unsigned char color[4]);

/* A straight line, `thickness` wide. */
void overlay_line(demo_overlay *overlay, const double from[2], const double to[2], double thickness,
                  const unsigned char color[4]);

/* `text` is ASCII and may have newlines. At a scale of 1, a line is OVERLAY_LINE high. */
void overlay_text(demo_overlay *overlay, double x, double y, double scale, const char *text, const unsigned char color[4]);

/* The width of the widest line. */
double overlay_text_width(const char *text, double scale);

/* Draws what was collected over the bound framebuffer, of `width` x `height` pixels. */
void overlay_draw(demo_overlay *overlay, int width, int height);

/* `overlay` may be NULL. */
void overlay_destroy(demo_overlay *overlay);

#endif
