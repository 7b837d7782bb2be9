/*
 * A scene's camera as matrices, in double precision: column-major, for column vectors, view space looking along -z.
 */
#ifndef CAMERA_H
#define CAMERA_H

#include "scene.h"

/* World to view: a rotation and a translation. */
void camera_view(const scene_camera *camera, double view[16]);

/* View to clip, OpenGL's depth range; `aspect` is width over height. */
void camera_projection(const scene_camera *camera, double aspect, double projection[16]);

/* A world position in view space. The eye is subtracted first, so that a world far from its origin loses nothing. */
void camera_to_view(const scene_camera *camera, const double position[3], double result[3]);

/* A world direction, turned into view space. */
void camera_turn_to_view(const scene_camera *camera, const double direction[3], double result[3]);

#endif
