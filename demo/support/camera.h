/*
 * A scene's camera as matrices. They are column-major and multiply column vectors; the camera looks along -z in view space.
 */
#ifndef CAMERA_H
#define CAMERA_H

#include "scene.h"

/* The camera's right, up and backward as unit vectors in the world: the rows of the view matrix's rotation. */
void camera_axes(const scene_camera *camera, double result[3][3]);

/* From world to view space: a rotation and a translation. */
void camera_view(const scene_camera *camera, double view[16]);

/* From view to clip space, with depths from -1 to 1. `aspect` is width over height. */
void camera_projection(const scene_camera *camera, double aspect, double projection[16]);

/* Transforms a position from world to view space. Subtracts the eye first, which keeps precision far from the world's origin.
 */
void camera_to_view(const scene_camera *camera, const double position[3], double result[3]);

/* Transforms a direction from world to view space. */
void camera_turn_to_view(const scene_camera *camera, const double direction[3], double result[3]);

#endif
