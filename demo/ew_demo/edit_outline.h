/*
 * The selected part over the picture: its shape as a line, and the handles that can be dragged.
 */
#ifndef EDIT_OUTLINE_H
#define EDIT_OUTLINE_H

#include "overlay.h"
#include "scene.h"
#include "scene_part.h"

typedef struct edit_outline {
    const demo_scene *scene;
    const char *text;           /* what the scene was read from */
    const scene_camera *camera; /* as seen */
    double width, height;       /* of the picture, in pixels */
    double scale;
} edit_outline;

/* Adds the part to the overlay. */
void edit_outline_draw(demo_overlay *overlay, const edit_outline *outline, scene_part part);

#endif
