/*
 * Draws a scene as a display shows it: the opaque shapes, and the energy over them, in 8-bit sRGB.
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
    DISPLAY_EVALUATIONS, /* a map of how often each pixel's ray was evaluated */
    DISPLAY_ERROR,       /* a map of errors, against Simpson's rule with MAP_REFERENCE_DIVISIONS */
} display_mode;

typedef struct display_view {
    const demo_scene *scene;
    display_mode mode;
    /* The court's look: stone lit by the energy. The shapes of such a scene are taken from the first one drawn. Without it, the
     * picture is ew-render's. The energy is drawn alike in both. */
    bool court_look;
    render_settings settings; /* the picture's size, and how to integrate */
    int samples_per_axis;     /* a pixel has the square of this many samples, which smooth the edges of shapes */
    bool split;               /* integrate the right half of the picture as `right` says */
    render_settings right;    /* its size is not used */
    bool count_evaluations;   /* in DISPLAY_PICTURE, too; costs a second draw */
} display_view;

/* Of the left (or only) or the right half of the last picture. Numbers that are unknown are negative. */
typedef struct display_statistics {
    double gpu_milliseconds; /* the energy's, a few frames ago */
    map_statistics map;
} display_statistics;

/* `gl` and `desc` are for the current context, which must be current in every later call. Returns NULL, with a message, on
 * failure. */
demo_display *display_create(const gl_functions *gl, const ew_effect_desc *desc, char *message, size_t size);

/* Gives the effect the sources that will be drawn. It may refuse some that a scene file holds: too many, or bent too much. Then
 * `message` says what to mend, and nothing changes. */
bool display_set_sources(demo_display *display, const ew_sources_desc *sources, char *message, size_t size);

/* Takes one step of compiling what the view needs, as ew_prepare_step does. Returns how many steps are left, 0 if display_draw
 * need not wait, or -1 on failure, which display_draw reports. */
int display_prepare(demo_display *display, const display_view *view);

/* Draws a picture into the display's own framebuffer. On failure returns false, with a message. */
bool display_draw(demo_display *display, const display_view *view, char *message, size_t size);

/* The framebuffer of the last picture, whose lower left corner is at (0, 0). */
GLuint display_framebuffer(const demo_display *display);

void display_size(const demo_display *display, int *width, int *height);

/* Reads the last picture: 3 or 4 bytes a pixel, the fourth of which is 255, and rows from the bottom up. OpenGL ES reads 4. */
void display_read(const demo_display *display, int channels, unsigned char *srgb);

display_statistics display_statistics_of(const demo_display *display, int half);

/* `display` may be NULL. */
void display_destroy(demo_display *display);

#endif
