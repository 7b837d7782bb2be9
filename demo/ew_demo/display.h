/*
 * Where a scene becomes a picture on a display: the opaque shapes, the energy over them, both developed to 8-bit sRGB.
 */
#ifndef DISPLAY_H
#define DISPLAY_H

#include "energywave.h"
#include "gl_functions.h"
#include "map.h"
#include "render.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_display demo_display;

typedef enum display_mode {
    DISPLAY_PICTURE,
    DISPLAY_EVALUATIONS, /* how often each pixel's ray was evaluated */
    DISPLAY_ERROR,       /* against MAP_REFERENCE_DIVISIONS of the papers' rule */
} display_mode;

typedef struct display_view {
    const demo_scene *scene;
    display_mode mode;
    /* The court's look: stone lit by the energy, and graded film. The shapes of such a scene are taken from the first one
     * drawn. Without it, the picture is ew-render's. */
    bool court_look;
    render_settings settings; /* the picture's size, and how to integrate */
    int samples_per_axis;     /* the edges of shapes are smoothed by the square of this many samples a pixel */
    /* Integrate the right half of the picture in another way, of which the size does not count. */
    bool split;
    render_settings right;
    bool count_evaluations; /* for the statistics of a DISPLAY_PICTURE, at the cost of a second draw */
} display_view;

/* Of the last picture, its left half (or whole) and its right half. Negative where unknown. */
typedef struct display_statistics {
    double gpu_milliseconds; /* that the energy took, a few frames ago */
    map_statistics map;
} display_statistics;

/* Functions and effect are to be those of the current context, and so in every call that follows. NULL, with a message, on
 * failure. */
demo_display *display_create(const gl_functions *gl, const ew_effect_desc *desc, char *message, size_t size);

/* Draws the picture into the display's own framebuffer. On failure returns false, with a message. */
bool display_draw(demo_display *display, const display_view *view, char *message, size_t size);

/* Where the last picture stands, from its lower left corner on: GL's name of a framebuffer. */
GLuint display_framebuffer(const demo_display *display);

void display_size(const demo_display *display, int *width, int *height);

/* The last picture: 3 bytes a pixel, rows from the bottom up. */
void display_read(const demo_display *display, unsigned char *srgb);

display_statistics display_statistics_of(const demo_display *display, int half);

/* `display` may be NULL. */
void display_destroy(demo_display *display);

#endif
