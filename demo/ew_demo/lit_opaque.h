/*
 * Draws the court: opaque boxes and spheres, lit by the moon and the sky, with shadows, and by the energy, as ew_draw lights a
 * deferred renderer's picture.
 */
#ifndef LIT_OPAQUE_H
#define LIT_OPAQUE_H

#include "energywave.h"
#include "gl_functions.h"
#include "render.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct lit_opaque lit_opaque;

/* Uploads the scene's opaque shapes, at most COURT_MAX_SHAPES. Later changes to them have no effect. Returns NULL, with a
 * message, on failure. */
lit_opaque *lit_opaque_create(const gl_functions *gl, const demo_scene *scene, char *message, size_t size);

/* Has a view mirror the world in the floor, y = 0, before it is viewed. */
void lit_opaque_mirror(double view[16]);

typedef struct lit_opaque_view {
    const demo_scene *scene;
    const render_settings *settings; /* of the picture's size */
    bool is_mirrored;                /* in the floor, y = 0, which itself is not drawn then */
    GLuint reflection;               /* a texture of what the floor reflects, of any size; 0 for none */
    GLuint depth;                    /* a texture of the picture's size, which gets the depth */
    GLuint framebuffer;              /* of the picture's size and without that depth, which gets the colour */
} lit_opaque_view;

/* Makes ready to draw that view. */
void lit_opaque_fit(lit_opaque *lit, const lit_opaque_view *view);

/* The frame that has the energy light the court, once it is ready to draw that view. */
ew_frame_desc lit_opaque_frame(const lit_opaque *lit, const lit_opaque_view *view);

/* Draws the shapes. The effect has the scene's sources. Leaves no framebuffer bound. */
ew_result lit_opaque_draw(lit_opaque *lit, const lit_opaque_view *view, ew_effect *effect, ew_error *error);

/* `lit` may be NULL. */
void lit_opaque_destroy(lit_opaque *lit);

#endif
