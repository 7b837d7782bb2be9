/*
 * What is under the pointer: the source whose light there is largest.
 */
#ifndef SCENE_PICK_H
#define SCENE_PICK_H

#include "camera_ray.h"
#include "scene.h"
#include "source_part.h"

#include <stdbool.h>

/* Finds the source whose light along the ray is largest, and not behind an opaque shape. One need not hit thin cores exactly:
 * the ray is `width` wide at unit depth, or everywhere if `scene`'s camera is orthographic. Returns false where there is no
 * light worth a click. */
bool scene_pick(const demo_scene *scene, const camera_ray *ray, double width, source_part *found);

#endif
