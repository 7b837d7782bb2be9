/*
 * Where a scene becomes a picture on a display: the opaque shapes, the energy over them, both developed to 8-bit sRGB.
 */
#ifndef STAGE_H
#define STAGE_H

#include "energywave.h"
#include "gl_functions.h"
#include "map.h"
#include "render.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_stage demo_stage;

typedef enum stage_mode {
    STAGE_PICTURE,
    STAGE_EVALUATIONS, /* how often each pixel's ray was evaluated */
    STAGE_ERROR,       /* against MAP_REFERENCE_DIVISIONS of the papers' rule */
} stage_mode;

typedef struct stage_view {
    const demo_scene *scene;
    stage_mode mode;
    /* The court's look: stone lit by the energy, and graded film. The shapes of such a scene are taken from the first one
     * drawn. Without it, the picture is ew-render's. */
    bool lit;
    render_settings settings; /* the picture's size, and how to integrate */
    int samples_per_axis;     /* the edges of shapes are smoothed by the square of this many samples a pixel */
    /* Integrate the right half of the picture in another way, of which the size does not count. */
    bool split;
    render_settings right;
    bool count_evaluations; /* for the statistics of a STAGE_PICTURE, at the cost of a second draw */
} stage_view;

/* Of the last picture, its left half (or whole) and its right half. Negative where unknown. */
typedef struct stage_statistics {
    double gpu_milliseconds; /* that the energy took, a few frames ago */
    map_statistics map;
} stage_statistics;

/* Functions and effect are to be those of the current context, and so in every call that follows. NULL, with a message, on
 * failure. */
demo_stage *stage_create(const gl_functions *gl, const ew_effect_desc *desc, char *message, size_t size);

/* Draws the picture into the stage's own framebuffer. On failure returns false, with a message. */
bool stage_draw(demo_stage *stage, const stage_view *view, char *message, size_t size);

/* Where the last picture stands, from its lower left corner on: GL's name of a framebuffer. */
GLuint stage_framebuffer(const demo_stage *stage);

void stage_size(const demo_stage *stage, int *width, int *height);

/* The last picture: 3 bytes a pixel, rows from the bottom up. */
void stage_read(const demo_stage *stage, unsigned char *srgb);

stage_statistics stage_statistics_of(const demo_stage *stage, int half);

/* `stage` may be NULL. */
void stage_destroy(demo_stage *stage);

#endif
