/*
 * The camera in the user's hands: around what it looks at, or anywhere. No window is known here.
 */
#ifndef CAMERA_CONTROL_H
#define CAMERA_CONTROL_H

#include "scene.h"

#include <stdbool.h>

typedef struct camera_control {
    bool is_free; /* from the first movement on; until then the scene's own camera counts */
    scene_camera camera;
} camera_control;

/* Each takes the camera over from `scene`, unless it is free already, and moves it. Angles are in degrees. */

/* The eye goes round the target: to the right, and up, short of the poles. */
void camera_control_orbit(camera_control *control, const demo_scene *scene, double right, double up);

/* The target goes round the eye. */
void camera_control_look(camera_control *control, const demo_scene *scene, double right, double up);

/* Both go along the camera's own right, up and forward, in world units. */
void camera_control_fly(camera_control *control, const demo_scene *scene, const double distance[3]);

/* The eye comes nearer to the target, by the factor `nearness`, > 0; an orthographic camera sees so much less. */
void camera_control_approach(camera_control *control, const demo_scene *scene, double nearness);

/* The scene as the free camera sees it. The copy shares everything with `scene`. The interval of a scene file is laid around
 * what its camera looks at; so it moves with that if `interval_follows`. */
demo_scene camera_control_scene(const camera_control *control, const demo_scene *scene, bool interval_follows);

#endif
