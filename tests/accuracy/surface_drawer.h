/*
 * The irradiance that the library's text for hosts finds at any surfaces.
 */
#ifndef SURFACE_DRAWER_H
#define SURFACE_DRAWER_H

#include "context.h"
#include "energywave.h"
#include "reference_irradiance.h"

enum { SURFACE_DRAWER_SIDE = 8, SURFACE_DRAWER_COUNT = SURFACE_DRAWER_SIDE * SURFACE_DRAWER_SIDE, MAX_SURFACE_PROGRAMS = 256 };

/* A text of the library's, and the program that was made of it. */
typedef struct surface_program {
    char *text;
    GLuint name;
} surface_program;

typedef struct surface_drawer {
    const gl_functions *gl;
    PFNGLBINDBUFFERBASEPROC bind_buffer_base;
    ew_effect *effect;
    GLuint positions, normals; /* textures */
    GLuint target, framebuffer;
    GLuint vertex_array; /* without arrays */
    surface_program programs[MAX_SURFACE_PROGRAMS];
    int program_count;
} surface_drawer;

bool surface_drawer_create(gl_context *context, ew_effect *effect, surface_drawer *drawer, char *message, size_t size);
void surface_drawer_destroy(surface_drawer *drawer);

/* Fills `light` with the irradiance of surfaces whose positions are relative to the eye. On failure returns false, with a
 * message; *has_room is false where the sources are too many for a uniform block. */
bool surface_drawer_draw(surface_drawer *drawer, const ew_sources_desc *sources, const ew_frame_desc *frame,
                         const reference_surface surfaces[SURFACE_DRAWER_COUNT], float light[SURFACE_DRAWER_COUNT][4],
                         bool *has_room, char *message, size_t size);

#endif
