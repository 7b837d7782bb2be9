/*
 * The layers into which the court is drawn before it is lit, as a deferred renderer has them.
 */
#ifndef COURT_LAYERS_H
#define COURT_LAYERS_H

#include "gl_functions.h"

typedef struct court_layers {
    int width; /* 0 while there are none */
    int height;
    GLuint depth;                     /* not theirs */
    GLuint albedo, own_light, normal; /* see lit_opaque.frag */
    GLuint framebuffer;               /* of all four */
    GLuint albedo_framebuffer;        /* of the albedo alone */
} court_layers;

/* Makes the layers anew if they are not of that size or have another depth. They start as {0}. */
void court_layers_fit(const gl_functions *gl, court_layers *layers, int width, int height, GLuint depth);

/* Binds and clears them. Where nothing is drawn, the court has faded into the dark. */
void court_layers_begin(const gl_functions *gl, const court_layers *layers);

void court_layers_destroy(const gl_functions *gl, court_layers *layers);

#endif
