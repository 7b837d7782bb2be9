/* Places to draw to, for tests: images and the framebuffer of them. */
#ifndef TEST_CANVAS_H
#define TEST_CANVAS_H

#include "api.h"

typedef struct canvas {
    int width, height;
    GLenum color_format;
    GLuint color, depth; /* renderbuffers */
    GLuint framebuffer;
} canvas;

/* A depth_format of 0: without; 0 samples: single-sampled. */
canvas canvas_create(int width, int height, GLenum color_format, GLenum depth_format, int samples);
void canvas_destroy(canvas *made);

/* Clears the colour. */
void canvas_clear(const canvas *cleared, const GLfloat color[4]);

/* Clears the depth, and then that of a rectangle to another. */
void canvas_clear_depth(const canvas *cleared, GLfloat far_depth, const GLint rectangle[4], GLfloat near_depth);

/* Four floats a pixel, rows from the bottom up; fixed-point colours as fractions of 1, encoded as they are. */
void canvas_read(const canvas *read, GLfloat *pixels);

/* Makes `to` the mean of the samples of `from`. */
void canvas_resolve(const canvas *from, const canvas *to);

#endif
