/*
 * A scene set up so that any integrator can draw its luminance onto one and the same target.
 */
#ifndef STAGE_H
#define STAGE_H

#include "context.h"
#include "integrator.h"
#include "peers.h"
#include "render.h"
#include "scene_file.h"

typedef struct bench_stage {
    const gl_functions *gl;
    int width;
    int height;
    render_target target;
    ew_frame_desc frame; /* onto the target's luminance */
    ew_effect *effect;
    bench_peers *peers;
} bench_stage;

/* Draws the scene's opaque shapes; where there are none, no depth is read by anyone. On failure returns false, with a message
 * and nothing to destroy. */
bool stage_create(gl_context *context, const demo_scene *scene, int width, int height, bench_stage *stage, char *message,
                  size_t size);
void stage_destroy(bench_stage *stage);

/* Draws; `output` is EW_OUTPUT_LUMINANCE, EW_OUTPUT_EVALUATIONS, or EW_OUTPUT_ADD for a frame as hosts draw it, added to what
 * the target has. Peers know only the first two, and draw the luminance in place of the third. */
bool stage_draw(bench_stage *stage, const bench_integrator *integrator, ew_output output, char *message, size_t size);

/* What was drawn last: one float a pixel, rows from the bottom. */
void stage_read(const bench_stage *stage, float *pixels);

/* Whether the scene has opaque shapes; then their depth, like stage_read. */
bool stage_read_depth(const bench_stage *stage, float *depth);

#endif
