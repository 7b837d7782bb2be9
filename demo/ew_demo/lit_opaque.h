/*
 * Opaque boxes and spheres, shadowed, and lit by the moon, the sky and the energy: what the court is drawn with.
 */
#ifndef LIT_OPAQUE_H
#define LIT_OPAQUE_H

#include "gl_functions.h"
#include "scene_file.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct lit_opaque lit_opaque;

/* Makes the triangles of the scene's opaque shapes, at most COURT_MAX_SHAPES, which are to stay as they are. NULL, with a
 * message, on failure. */
lit_opaque *lit_opaque_create(const gl_functions *gl, const ew_scene *scene, char *message, size_t size);

/* Clears the bound framebuffer's colour and depth and draws the shapes into it, in the light of the scene's sources. */
void lit_opaque_draw(const lit_opaque *lit, const ew_scene *scene, int width, int height);

/* `lit` may be NULL. */
void lit_opaque_destroy(lit_opaque *lit);

#endif
