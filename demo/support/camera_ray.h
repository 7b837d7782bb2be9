/*
 * Between places in a camera's picture and places in the world. Places in the picture are from -1 to 1, to the right and up;
 * `aspect` is the picture's width over its height.
 */
#ifndef CAMERA_RAY_H
#define CAMERA_RAY_H

#include "scene.h"

typedef struct camera_ray {
    double origin[3];
    double direction[3]; /* its view depth is 1 */
} camera_ray;

/* The ray that is seen at a place of the picture. */
camera_ray camera_ray_at(const scene_camera *camera, double aspect, const double place[2]);

/* How many world units there are from the middle of the picture to its top, at a view depth. */
double camera_half_height(const scene_camera *camera, double depth);

/* Sets `place` to where a position is seen, and returns its view depth. A place that is not in front of the eye means nothing.
 */
double camera_project(const scene_camera *camera, double aspect, const double position[3], double place[2]);

/* Moves a position across the view, to where it is seen at the place of the picture. */
void camera_move_across(const scene_camera *camera, double aspect, const double place[2], double position[3]);

#endif
