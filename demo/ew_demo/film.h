/*
 * The last step of a picture: composites the energy over the opaque scene, and encodes it for a display.
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
    GLuint energy; /* the effect, drawn over transparent black */
    bool soft;     /* it was drawn with EW_OUTPUT_SOFT */
    int samples_per_axis;
    bool graded;        /* with the steep gradation of film */
    double sensitivity; /* to the energy, if graded */
    bool encoded;       /* to sRGB; else linear */
} film_exposure;

/* Fills `framebuffer`. Each of its pixels is the mean of samples_per_axis x samples_per_axis texels. */
void film_develop(const gl_functions *gl, const demo_film *film, const film_exposure *exposure, GLuint framebuffer, int width,
                  int height);

#endif
