/*
 * Opaque boxes and spheres, shadowed, and lit by the moon, the sky and the energy: what the court is drawn with.
 */
#ifndef LIT_OPAQUE_H
#define LIT_OPAQUE_H

#include "gl_functions.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct lit_opaque lit_opaque;

/* Makes the triangles of the scene's opaque shapes, at most COURT_MAX_SHAPES, which are to stay as they are. NULL, with a
 * message, on failure. */
lit_opaque *lit_opaque_create(const gl_functions *gl, const demo_scene *scene, char *message, size_t size);

typedef struct lit_opaque_view {
    const demo_scene *scene;
    int width;
    int height;
    bool is_mirrored;  /* at the floor, y = 0, of which nothing is drawn then */
    GLuint reflection; /* what the floor mirrors, a texture as large as the picture or smaller; 0 for nothing */
} lit_opaque_view;

/* Clears the bound framebuffer's colour and depth and draws the shapes into it, in the light of the scene's sources. */
void lit_opaque_draw(const lit_opaque *lit, const lit_opaque_view *view);

/* `lit` may be NULL. */
void lit_opaque_destroy(lit_opaque *lit);

#endif
