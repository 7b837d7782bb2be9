/*
 * The camera as the user moves it: around its target, or anywhere. This knows of no window.
 */
#ifndef CAMERA_CONTROL_H
#define CAMERA_CONTROL_H

#include "scene.h"

#include <stdbool.h>

typedef struct camera_control {
    bool is_free; /* true from the first movement on; until then the scene's own camera is used */
    scene_camera camera;
} camera_control;

/* The first four functions move the camera. One that is not free yet starts from the camera of `scene`. Angles are in degrees.
 */

/* Moves the eye around the target, to the right and up, but not over the poles. */
void camera_control_orbit(camera_control *control, const demo_scene *scene, double right, double up);

/* Moves the target around the eye. */
void camera_control_look(camera_control *control, const demo_scene *scene, double right, double up);

/* Moves both along the camera's right, up and forward, in world units. */
void camera_control_fly(camera_control *control, const demo_scene *scene, const double distance[3]);

/* Divides the distance from the eye to the target, and the height of an orthographic picture, by `nearness`, which is > 0. */
void camera_control_approach(camera_control *control, const demo_scene *scene, double nearness);

/* The scene as the free camera sees it. The copy shares all lists with `scene`. With `interval_follows`, the interval, if
 * there is one, moves by as much as the target's distance changes, because scene files place it around the target. */
demo_scene camera_control_scene(const camera_control *control, const demo_scene *scene, bool interval_follows);

#endif
