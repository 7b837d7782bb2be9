/* Framebuffers for tests to draw to, and their attachments. */
#ifndef TEST_CANVAS_H
#define TEST_CANVAS_H

#include "api.h"

typedef struct canvas {
    int width, height;
    GLenum color_format;
    GLuint color, depth; /* renderbuffers */
    GLuint framebuffer;
} canvas;

/* A depth_format of 0 leaves out the depth; 0 samples make a single-sampled canvas. */
canvas canvas_create(int width, int height, GLenum color_format, GLenum depth_format, int samples);
void canvas_destroy(canvas *made);

/* Clears the colour. */
void canvas_clear(const canvas *cleared, const GLfloat color[4]);

/* Clears the depth to far_depth, and then that of the rectangle to near_depth. */
void canvas_clear_depth(const canvas *cleared, GLfloat far_depth, const GLint rectangle[4], GLfloat near_depth);

/* Reads four floats a pixel, rows from the bottom up. Fixed-point colours are fractions of 1 and stay encoded. */
void canvas_read(const canvas *read, GLfloat *pixels);

/* Sets each pixel of `to` to the mean of the samples of `from`. */
void canvas_resolve(const canvas *from, const canvas *to);

#endif
