/*
 * The sliders of the selected part: what they show, where they are, and what the pointer and the keys do to them. Opaque shapes
 * have none, media two.
 */
#ifndef EDIT_PANEL_H
#define EDIT_PANEL_H

#include "overlay.h"
#include "scene.h"
#include "scene_part.h"

#include <stdbool.h>

enum { EDIT_MOST_SLIDERS = 3, EDIT_NO_SLIDER = -1 };

typedef struct edit_slider {
    const char *key; /* of the part's member in the scene file */
    double value;    /* 0 where there is none */
    double least, most;
    bool is_logarithmic;
    double lower, upper; /* what the part's other members leave of it */
} edit_slider;

typedef struct edit_panel {
    char title[60];
    edit_slider sliders[EDIT_MOST_SLIDERS];
    int slider_count;
    int chosen; /* which of them the keys change */
    bool is_saved;
} edit_panel;

/* The panel of a part; `text` is what the scene was read from. */
edit_panel edit_panel_of(const demo_scene *scene, const char *text, scene_part part);

/* Where the panel is in a window of this width, in pixels. */
typedef struct edit_place {
    int width;
    double scale;
} edit_place;

/* Whether a pixel is on the panel, and on which slider. */
bool edit_panel_has(const edit_panel *panel, edit_place place, double x, double y);
int edit_panel_slider_at(const edit_panel *panel, edit_place place, double x, double y);

/* What a slider says when it is dragged to a column of pixels: three digits, within what the part's other members allow. */
double edit_panel_value_at(const edit_panel *panel, int slider, edit_place place, double x);

/* What it says when it is moved by a part of its length: likewise, or what it said if it cannot go there. */
double edit_panel_value_beside(const edit_panel *panel, int slider, double way);

/* Adds the panel to the overlay. */
void edit_panel_draw(demo_overlay *overlay, const edit_panel *panel, edit_place place);

#endif
