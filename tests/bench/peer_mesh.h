/*
 * Quads that carry painted light, for billboards and ribbons: one additive draw, with a falloff for each source, faded where
 * they come near to the opaque scene (soft particles). All is uploaded once, in the peers' favour.
 */
#ifndef PEER_MESH_H
#define PEER_MESH_H

#include "context.h"
#include "peer_outline.h"
#include "peer_profile.h"

typedef struct mesh_vertex {
    float position[3]; /* in the view's space: of the source, not of the quad's corner */
    float level;       /* of light */
    float tangent[3];  /* of the source there */
    float row;         /* which of the falloffs */
    float offset[2];   /* of the corner from the position, in reaches */
    float reach;
} mesh_vertex;

/* What a mesh is made of: quads of four vertices as in a strip, and falloffs. */
typedef struct mesh_data {
    mesh_vertex *vertices;
    size_t vertex_count;
    float *profiles;
    size_t profile_count;
    size_t capacity, profile_capacity;
    bool is_out_of_memory;
} mesh_data;

/* Appends a quad, unless memory is exhausted. */
void mesh_data_add_quad(mesh_data *data, const mesh_vertex corners[4]);

/* Appends a falloff, to be filled; NULL where memory is exhausted. */
float *mesh_data_add_profile(mesh_data *data);

typedef struct peer_mesh {
    GLuint vertex_array;
    GLuint buffers[2];
    GLuint profiles;
    GLuint program;
    GLsizei index_count;
} peer_mesh;

/* How a peer draws: `add_source` appends a source's falloff and quads, `count` of them or a few more, and `vertex_shader` puts
 * the corners into their places. */
typedef struct mesh_style {
    const char *name; /* for messages */
    const char *vertex_shader;
    void (*add_source)(mesh_data *data, const outline *shape, int count);
} mesh_style;

/* Each source needs a reach. On failure returns false, with a message and nothing to destroy. */
bool peer_mesh_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, const mesh_style *style,
                      int count, peer_mesh *mesh, char *message, size_t size);
void peer_mesh_destroy(const gl_functions *gl, peer_mesh *mesh);

/* Clears the frame's target and draws. */
void peer_mesh_draw(const gl_functions *gl, const peer_mesh *mesh, const ew_frame_desc *frame);

#endif
