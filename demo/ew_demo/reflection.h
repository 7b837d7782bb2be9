/*
 * What the court's polished floor reflects: the mirrored scene, at half the picture's size.
 */
#ifndef REFLECTION_H
#define REFLECTION_H

#include "energywave.h"
#include "film.h"
#include "gl_functions.h"
#include "lit_opaque.h"
#include "render.h"

#include <stdbool.h>

typedef struct floor_reflection {
    int width; /* 0 while there are no targets */
    int height;
    GLuint opaque, depth, energy, picture;
    GLuint opaque_framebuffer, energy_framebuffer, picture_framebuffer;
} floor_reflection;

/* Draws the reflection for a picture of the settings' size into reflection->picture, in linear colour. The effect has the
 * scene's sources. */
ew_result reflection_draw(const gl_functions *gl, floor_reflection *reflection, ew_effect *effect, const lit_opaque *lit,
                          const demo_film *film, const demo_scene *scene, const render_settings *settings, double sensitivity,
                          ew_error *error);

void reflection_destroy(const gl_functions *gl, floor_reflection *reflection);

#endif
