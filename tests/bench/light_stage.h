/*
 * A scene whose opaque surfaces are to be lit: by the library, or by point lights along its sources.
 */
#ifndef LIGHT_STAGE_H
#define LIGHT_STAGE_H

#include "render.h"
#include "scene_file.h"

enum { MAX_POINT_LIGHTS = 8192 };

typedef struct light_stage {
    gl_context *context;
    const gl_functions *gl;
    const demo_scene *scene;
    render_settings settings;
    render_target target;
    ew_effect *effect;
    GLuint surfaces[2]; /* textures: positions relative to the eye, and normals along the world's axes */
    GLuint surface_framebuffer;
    GLuint surface_program, peer_program;
    GLuint lights; /* a texture: see light_peer.glsl */
    GLuint vertex_array;
} light_stage;

/* On failure returns false, with a message and nothing to destroy. */
bool light_stage_create(gl_context *context, const demo_scene *scene, int width, int height, light_stage *stage, char *message,
                        size_t size);
void light_stage_destroy(light_stage *stage);

/* Puts `count` point lights at even distances along the sources, as many as the sources at the least. */
void light_stage_set_lights(light_stage *stage, int count);

/* Clears the target's colour to 1, the albedo of all surfaces. */
void light_stage_clear(light_stage *stage);

/* Adds light to it. */
bool light_stage_draw(light_stage *stage, bool has_shadows, char *message, size_t size);
void light_stage_draw_lights(light_stage *stage, int count);

/* Fills what was drawn and the surfaces: 4 floats a pixel, rows from the bottom. */
void light_stage_read(light_stage *stage, float *color, float *positions, float *normals);

#endif
