/*
 * Draws the court: opaque boxes and spheres, lit by the moon, the sky and the energy, with shadows.
 */
#ifndef LIT_OPAQUE_H
#define LIT_OPAQUE_H

#include "gl_functions.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct lit_opaque lit_opaque;

/* Uploads the scene's opaque shapes, at most COURT_MAX_SHAPES. Later changes to them have no effect. Returns NULL, with a
 * message, on failure. */
lit_opaque *lit_opaque_create(const gl_functions *gl, const demo_scene *scene, char *message, size_t size);

typedef struct lit_opaque_view {
    const demo_scene *scene;
    int width;
    int height;
    bool is_mirrored;  /* in the floor, y = 0, which itself is not drawn then */
    GLuint reflection; /* a texture of what the floor reflects, of any size; 0 for none */
} lit_opaque_view;

/* Clears the bound framebuffer's colour and depth, and draws the shapes into it. */
void lit_opaque_draw(const lit_opaque *lit, const lit_opaque_view *view);

/* `lit` may be NULL. */
void lit_opaque_destroy(lit_opaque *lit);

#endif
