/*
 * The last step of a picture: averages its samples and encodes it for a display. It changes no light.
 */
#ifndef RESOLVE_H
#define RESOLVE_H

#include "gl_functions.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct resolve_pass {
    GLuint program;
    GLuint no_vertices;
} resolve_pass;

/* On failure returns false, with a message and nothing to destroy. */
bool resolve_create(const gl_functions *gl, resolve_pass *pass, char *message, size_t size);
void resolve_destroy(const gl_functions *gl, resolve_pass *pass);

typedef struct resolve_input {
    GLuint color; /* linear */
    int samples_per_axis;
    bool dithers; /* so that dark gradients do not band */
} resolve_input;

/* Fills `framebuffer` with 8-bit sRGB. Each of its pixels is the mean of samples_per_axis x samples_per_axis texels. */
void resolve_draw(const gl_functions *gl, const resolve_pass *pass, const resolve_input *input, GLuint framebuffer, int width,
                  int height);

#endif
