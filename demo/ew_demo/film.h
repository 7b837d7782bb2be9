/*
 * The last step of a picture: the energy's layer over the opaque scene, as a display or a mirror shows it.
 */
#ifndef FILM_H
#define FILM_H

#include "gl_functions.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_film {
    GLuint program;
    GLuint no_vertices;
} demo_film;

/* On failure returns false, with a message and nothing to destroy. */
bool film_create(const gl_functions *gl, demo_film *film, char *message, size_t size);
void film_destroy(const gl_functions *gl, demo_film *film);

typedef struct film_exposure {
    GLuint opaque; /* linear colour */
    GLuint energy; /* the effect, drawn over nothing */
    int samples_per_axis;
    bool graded;        /* steeply, or as it is */
    double sensitivity; /* to the energy, where it is graded */
    bool encoded;       /* to sRGB, or left linear */
} film_exposure;

/* Draws it into the whole of `framebuffer`, which is smaller than the textures by the samples. */
void film_develop(const gl_functions *gl, const demo_film *film, const film_exposure *exposure, GLuint framebuffer, int width,
                  int height);

#endif
