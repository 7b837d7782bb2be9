/*
 * The opaque shapes of a scene as triangles in the world. No GL.
 */
#ifndef OPAQUE_MESH_H
#define OPAQUE_MESH_H

#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct opaque_vertex {
    double position[3]; /* in world space */
    double normal[3];   /* unit vector, outward */
    double color[3];    /* linear RGB */
} opaque_vertex;

/* Triangles are counterclockwise as seen from outside. Hidden ones are included. */
typedef struct opaque_mesh {
    opaque_vertex *vertices;
    size_t vertex_count;
    unsigned (*triangles)[3];
    size_t triangle_count;
} opaque_mesh;

/* Makes the triangles of all opaque shapes. A sphere's vertices lie on it. A plane ends beyond the camera's far plane, where
 * that is not visible in pictures up to 4 times as wide as high. Returns false, with nothing to free, where memory is
 * exhausted. */
bool opaque_make_mesh(const demo_scene *scene, opaque_mesh *mesh);

void opaque_free_mesh(opaque_mesh *mesh);

#endif
