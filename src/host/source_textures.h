/* Textures that hand a plan's lists, and its sources where the uniform block is too small for them, to the shader. */
#ifndef EW_SOURCE_TEXTURES_H
#define EW_SOURCE_TEXTURES_H

#include "host/gl.h"
#include "plan/plan.h"

/* Starts as {0}. */
typedef struct ew_source_textures {
    GLuint lists, sources;
} ew_source_textures;

/* Fills and binds the textures that the shader of `key` reads. Changes the active texture unit and what is bound to those of
 * the textures. */
void ew_source_textures_bind(ew_source_textures *textures, const ew_gl *gl, const ew_plan *plan, unsigned key);

void ew_source_textures_destroy(ew_source_textures *textures, const ew_gl *gl);

#endif
