/*
 * Where a scene becomes a picture on a display: the opaque shapes, the energy over them, both developed to 8-bit sRGB.
 */
#ifndef STAGE_H
#define STAGE_H

#include "energywave.h"
#include "gl_functions.h"
#include "render.h"
#include "scene_file.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_stage demo_stage;

typedef struct stage_view {
    const ew_scene *scene;
    /* The court's look: stone lit by the energy, and graded film. The shapes of such a scene are taken from the first one
     * drawn. Without it, the picture is ew-render's. */
    bool lit;
    render_settings settings; /* the picture's size, and how to integrate */
    int samples_per_axis;     /* the edges of shapes are smoothed by the square of this many samples a pixel */
    /* Integrate the right half of the picture in another way, of which the size does not count. */
    bool split;
    render_settings right;
} stage_view;

/* Functions and effect are to be those of the current context, and so in every call that follows. NULL, with a message, on
 * failure. */
demo_stage *stage_create(const gl_functions *gl, const ew_effect_desc *desc, char *message, size_t size);

/* Draws the picture into the stage's own framebuffer. On failure returns false, with a message. */
bool stage_draw(demo_stage *stage, const stage_view *view, char *message, size_t size);

/* Where the last picture stands, from its lower left corner on: GL's name of a framebuffer. */
GLuint stage_framebuffer(const demo_stage *stage);

/* The last picture: 3 bytes a pixel, rows from the bottom up. */
void stage_read(const demo_stage *stage, unsigned char *srgb);

/* `stage` may be NULL. */
void stage_destroy(demo_stage *stage);

#endif
