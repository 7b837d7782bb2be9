/*
 * What of a scene's part can be dragged: its positions, where it points to, and how large it is.
 */
#ifndef PART_HANDLE_H
#define PART_HANDLE_H

#include "scene_part.h"

typedef enum handle_kind {
    HANDLE_POSITION,
    HANDLE_ELEMENT,   /* a position of a list */
    HANDLE_DIRECTION, /* the end of an arrow that is as long in the picture as others, since directions have no length */
    HANDLE_RADIUS,    /* the end of one */
    HANDLE_RADII,     /* the end of one of an ellipsoid's */
    HANDLE_BOX,       /* its middle, which moves all of it */
    HANDLE_MIN,       /* a corner of a box */
    HANDLE_MAX,
} handle_kind;

typedef struct part_handle {
    handle_kind kind;
    const char *key; /* of the member that it changes; of a box's middle, of one of two */
    size_t element;  /* of that list, or of the radii */
    double position[3];
    double from[3]; /* where the arrow or the radius begins */
} part_handle;

/* How many handles the part has. `text` is what the scene was read from. */
size_t part_handle_count(const demo_scene *scene, const char *text, scene_part part);

/* One of them, as `camera` sees it: arrows have their length by it, and radii lie across its view as far as they can. */
part_handle part_handle_at(const demo_scene *scene, const char *text, scene_part part, const scene_camera *camera,
                           size_t index);

/* Returns the text with the handle moved to a place, in numbers that are multiples of `step`, or of what `step` is there to an
 * arrow of length 1. The caller frees it; NULL where memory is exhausted. */
char *part_handle_move(const demo_scene *scene, const char *text, scene_part part, const part_handle *handle,
                       const double place[3], double step);

#endif
