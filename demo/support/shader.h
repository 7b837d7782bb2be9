/*
 * Shader programs.
 */
#ifndef SHADER_H
#define SHADER_H

#include "gl_functions.h"

/* Compiles and links a program. The texts are of OpenGL 3.3, whose version is their first line. On failure returns 0, with a
 * message that says whose shader it is: `name`, such as "the floor's". */
GLuint shader_link(const gl_functions *gl, const char *vertex_text, const char *fragment_text, const char *name, char *message,
                   size_t size);

#endif
