/* An opaque scene with samples, and what each of its samples holds. */
#ifndef TEST_SAMPLED_SCENE_H
#define TEST_SAMPLED_SCENE_H

#include "api.h"

#include <stdbool.h>

enum { SCENE_SAMPLES = 4 };

typedef struct opaque_triangle {
    GLfloat corners[3][3]; /* in normalized device coordinates */
    GLfloat color[4];
} opaque_triangle;

typedef struct sampled_scene {
    GLuint color, depth;                       /* multisampled; depth is GL_DEPTH_COMPONENT32F */
    GLuint framebuffer;                        /* of the colour alone */
    GLuint sample_color[SCENE_SAMPLES];        /* RGBA32F, single-sampled */
    GLuint sample_depth[SCENE_SAMPLES];        /* the same, in the red channel */
    GLuint sample_framebuffers[SCENE_SAMPLES]; /* of the colour alone */
} sampled_scene;

bool has_multisampled_textures(void);

/* Draws triangles before a dark background. */
void sampled_scene_create(const opaque_triangle *triangles, int count, GLenum color_format, int width, int height,
                          sampled_scene *scene);
void sampled_scene_destroy(sampled_scene *scene);

/* Fetches the samples of the colour anew. */
void sampled_scene_fetch_color(sampled_scene *scene, int width, int height);

GLuint make_float_texture(int width, int height);
GLuint make_framebuffer(GLenum texture_target, GLuint color, GLuint depth);

#endif
