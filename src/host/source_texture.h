/* The texture that hands a plan's sources, and their lists, to the shader where the uniform block is too small for them. */
#ifndef EW_SOURCE_TEXTURE_H
#define EW_SOURCE_TEXTURE_H

#include "host/gl.h"
#include "plan/plan.h"

/* Starts as {0}. */
typedef struct ew_source_texture {
    GLuint name;
} ew_source_texture;

/* Fills and binds the texture. Changes the active texture unit, and what is bound to the texture's. */
void ew_source_texture_bind(ew_source_texture *texture, const ew_gl *gl, const ew_plan *plan);

void ew_source_texture_destroy(ew_source_texture *texture, const ew_gl *gl);

#endif
