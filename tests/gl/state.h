/* Every piece of GL state that can be asked for: taken, kept and compared. Knows nothing of the library. */
#ifndef TEST_STATE_H
#define TEST_STATE_H

#include "api.h"

#include <stddef.h>

typedef struct state_value {
    const char *name;
    int index; /* of the texture unit, binding, object, ... */
    int component;
    double value;
} state_value;

typedef struct state {
    state_value *values;
    size_t count;
    size_t capacity;
} state;

typedef struct state_texture {
    GLenum target; /* GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE */
    GLuint name;
} state_texture;

/* The objects whose own state belongs to what is compared. */
typedef struct state_objects {
    const GLuint *framebuffers;
    int framebuffer_count;
    const GLuint *vertex_arrays;
    int vertex_array_count;
    const GLuint *buffers;
    int buffer_count;
    const GLuint *samplers;
    int sampler_count;
    const GLuint *programs;
    int program_count;
    const state_texture *textures;
    int texture_count;
} state_objects;

/* Adds all of the current context's state to `taken`, which starts as {0}, and leaves that state as it was. */
void state_take(state *taken, const state_objects *objects);

/* How many values differ; the first are printed to stderr. */
int state_count_differences(const state *before, const state *after);

void state_free(state *taken);

#endif
