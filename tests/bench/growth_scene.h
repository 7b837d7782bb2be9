/*
 * A frame to be timed: sources, a camera, and targets of any size and number of samples. Everything is done as a host would.
 */
#ifndef GROWTH_SCENE_H
#define GROWTH_SCENE_H

#include "context.h"
#include "render.h"
#include "scene.h"

/* Beams that are strewn over what a camera sees, always the same. */
typedef struct strewn_beams {
    demo_scene scene;
    ew_path *paths;
    double (*ends)[2][3];
} strewn_beams;

/* Makes `count` beams 1 long in front of a camera that sees 16 by 9 at their distance. Returns false where memory is exhausted.
 */
bool strewn_beams_create(size_t count, double reach, strewn_beams *beams);
void strewn_beams_free(strewn_beams *beams);

/* A frame's effect and target. */
typedef struct growth_frame {
    const gl_functions *gl;
    ew_effect *effect;
    GLuint color, depth;    /* textures */
    GLuint framebuffers[2]; /* of both, and of the colour alone */
    ew_frame_desc desc;
} growth_frame;

/* Prepares drawing a scene, with its opaque shapes, at a size. `samples` 1 is a target without multisampling. `loader` and
 * `user` are as in ew_effect_desc. On failure returns the error's code, with its text in `message`, and nothing to destroy. */
ew_result growth_frame_create(gl_context *context, const demo_scene *scene, int width, int height, int samples,
                              ew_gl_function (*loader)(void *user, const char *name), growth_frame *frame, char *message,
                              size_t size);
void growth_frame_destroy(growth_frame *frame);

/* Draws frames for about a second, one at least, and returns the median of their milliseconds; negative with a message on
 * failure. */
double growth_frame_time(gl_context *context, growth_frame *frame, ew_resolution resolution, char *message, size_t size);

/* The share of its pixels that are lit. Reads the picture that was drawn last; of frames without multisampling. Negative where
 * memory is exhausted. */
double growth_frame_lit_share(const growth_frame *frame);

#endif
