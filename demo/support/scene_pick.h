/*
 * What is under the pointer: the source whose light there is largest, or else the nearest opaque shape or medium.
 */
#ifndef SCENE_PICK_H
#define SCENE_PICK_H

#include "camera_ray.h"
#include "scene.h"
#include "scene_part.h"

#include <stdbool.h>

/* Finds the source whose light along the ray is largest, and not behind an opaque shape. One need not hit thin cores exactly:
 * the ray is `width` wide at unit depth, or everywhere if `scene`'s camera is orthographic. Where there is no light worth a
 * click, finds what is seen first, an opaque shape or a medium that the camera is not in; returns false where there is none
 * either. */
bool scene_pick(const demo_scene *scene, const camera_ray *ray, double width, scene_part *found);

#endif
