/*
 * The panel over the window's picture: what is shown, how fast it is drawn, and the keys.
 */
#ifndef PANEL_H
#define PANEL_H

#include "display.h"
#include "overlay.h"
#include "render.h"

#include <stdbool.h>

typedef struct panel_view {
    const char *scene_name;
    const char *gl_name;
    double seconds;
    int frames_per_second;
    double time_scale;
    bool is_paused;
    bool is_animated;
    double frame_milliseconds;
    display_mode mode;
    bool split;
    render_settings integrators[2];
    display_statistics statistics[2];
    bool shows_panel;
    bool shows_keys;
    const char *notice; /* empty for none */
    const char *error;  /* what is wrong with the scene file; empty if nothing is */
} panel_view;

/* Adds the panel to the overlay of a window of this size. `scale` is that of the monitor's content. */
void panel_draw(demo_overlay *overlay, const panel_view *view, int width, int height, double scale);

#endif
