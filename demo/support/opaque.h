/*
 * The opaque shapes of a scene in GL.
 */
#ifndef OPAQUE_H
#define OPAQUE_H

#include "gl_functions.h"
#include "opaque_mesh.h"

#include <stdbool.h>
#include <stddef.h>

/* A mesh in GL's memory: vertex attribute 0 is the position, 1 the normal, and 2 the colour. */
typedef struct opaque_buffers {
    GLuint vertex_array;
    GLuint buffers[2];
    GLsizei index_count;
} opaque_buffers;

/* Uploads the mesh in the view space of `camera`, or in world space if that is NULL. Returns false where memory is exhausted.
 */
bool opaque_upload(const gl_functions *gl, const opaque_mesh *mesh, const scene_camera *camera, opaque_buffers *buffers);

/* Draws the triangles with the current program and a depth test. */
void opaque_draw_buffers(const gl_functions *gl, const opaque_buffers *buffers);

void opaque_delete_buffers(const gl_functions *gl, opaque_buffers *buffers);

/* Clears the bound framebuffer's colour, which is linear, to the background, and its depth to the far plane. */
void opaque_clear(const gl_functions *gl, const demo_scene *scene);

/* Clears the bound framebuffer, and draws the shapes into it. Expects GL's initial state, and changes nothing of it but the
 * viewport and the bindings. On failure returns false, with a message. */
bool opaque_draw(const gl_functions *gl, const demo_scene *scene, int width, int height, char *message, size_t size);

#endif
