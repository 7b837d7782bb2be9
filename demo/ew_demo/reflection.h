/*
 * What the court's polished floor reflects: the mirrored scene, at half the picture's size.
 */
#ifndef REFLECTION_H
#define REFLECTION_H

#include "energywave.h"
#include "gl_functions.h"
#include "lit_opaque.h"
#include "render.h"

typedef struct floor_reflection {
    int width; /* 0 while there are no targets */
    int height;
    GLuint color, depth;
    GLuint effect_framebuffer; /* colour */
} floor_reflection;

/* Draws the reflection for a picture of the settings' size into reflection->color, in linear colour. The effect has the
 * scene's sources. */
ew_result reflection_draw(const gl_functions *gl, floor_reflection *reflection, ew_effect *effect, lit_opaque *lit,
                          const demo_scene *scene, const render_settings *settings, ew_error *error);

void reflection_destroy(const gl_functions *gl, floor_reflection *reflection);

#endif
