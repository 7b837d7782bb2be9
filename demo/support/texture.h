/*
 * Textures that are drawn into, and the framebuffers that do so.
 */
#ifndef TEXTURE_H
#define TEXTURE_H

#include "gl_functions.h"

/* Without mipmaps, read with the nearest texel. */
GLuint texture_create(const gl_functions *gl, int width, int height, GLint internal_format, GLenum format);

/* Draws into `color` and, where it is not 0, `depth`. *complete stays true only if the framebuffer can be drawn to. */
GLuint texture_framebuffer(const gl_functions *gl, GLuint color, GLuint depth, bool *complete);

#endif
