/*
 * Textures that are drawn into, and their framebuffers.
 */
#ifndef TEXTURE_H
#define TEXTURE_H

#include "gl_functions.h"

#include <stddef.h>

/* Creates a texture without mipmaps that is sampled at its nearest texel. */
GLuint texture_create(const gl_functions *gl, int width, int height, GLint internal_format, GLenum format);

/* Creates a framebuffer of `color` and, unless it is 0, `depth`. Sets *complete to false if it cannot be drawn to; leaves it
 * alone otherwise. */
GLuint texture_framebuffer(const gl_functions *gl, GLuint color, GLuint depth, bool *complete);

/* Says why GL has made no textures of floats that can be drawn to, from the error that it recorded, if any. */
void texture_write_refusal(GLenum error, int width, int height, char *message, size_t size);

/* The two functions below leave no framebuffer bound. */

/* Clears a framebuffer's colour to 0, opacity included. */
void texture_clear(const gl_functions *gl, GLuint framebuffer);

typedef struct pixel_rectangle {
    int x; /* from the left */
    int y; /* from the bottom */
    int width;
    int height;
} pixel_rectangle;

/* Reads a framebuffer's colour, rows from the bottom up without gaps. */
void texture_read(const gl_functions *gl, GLuint framebuffer, pixel_rectangle from, GLenum format, GLenum type, void *pixels);

#endif
