/*
 * Automatic exposure: the sensitivity that the film needs for the energy's mean luminance.
 */
#ifndef LIGHT_METER_H
#define LIGHT_METER_H

#include "gl_functions.h"
#include "render.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct light_meter {
    GLuint texture;
    GLuint framebuffer;
} light_meter;

/* On failure returns false, with a message; the meter must still be destroyed. */
bool light_meter_create(const gl_functions *gl, light_meter *meter, char *message, size_t size);
void light_meter_destroy(const gl_functions *gl, light_meter *meter);

/* Measures what the scene's camera sees, and sets *sensitivity. The effect has the scene's sources. */
ew_result light_meter_read(const gl_functions *gl, const light_meter *meter, ew_effect *effect, const demo_scene *scene,
                           const render_settings *settings, double *sensitivity, ew_error *error);

#endif
