/*
 * The scene file: JSON, version 1. Lengths are in world units, angles in degrees, colours linear RGB. The camera's eye and
 * target are required. Every other key at the top and in "camera" and "decay" is optional; the values shown are its defaults,
 * but a file without lists has no sources and no shapes:
 *
 *     { "version": 1, "comment": "free text",
 *       "camera": { "eye": [0,0,8], "target": [0,0,0], "up": [0,1,0], "fov_y_degrees": 45, "near": 0.1, "far": 100 },
 *       "interval": { "start": 3, "end": 15 },                               by default from near to far; end is at most far
 *       "decay": { "alpha": 1, "beta": 1 }, "epsilon": 0.001,
 *       "background": [0,0,0], "color": [0.2,0.5,1], "composite": "lerp",    or "add"
 *       "points": [ { "position": [..], "coefficient": 1, "color": [..] } ],
 *       "lines":  [ { "position": [..], "direction": [..], "coefficient": 1 } ],
 *       "tori":   [ { "center": [..], "axis": [..], "radius": 0.9, "coefficient": 5.1 } ],
 *       "curves": [ { "control_points": [[..],[..],[..]], "coefficient": 5, "weights": [1,0.2,0.6] },
 *                   { "polynomial": [C0, C1, C2], "domain": [-2, 2], "coefficient": 4 } ],
 *       "opaque": [ { "shape": "box", "min": [..], "max": [..], "color": [..] },
 *                   { "shape": "plane", "point": [..], "normal": [..], "color": [..] },
 *                   { "shape": "sphere", "center": [..], "radius": 1, "color": [..] } ] }
 *
 * A camera with "projection": "orthographic" takes, instead of fov_y_degrees, the "height" of its picture in world units, 2 by
 * default. Of a source, "coefficient" is 1 by default, "color" the scene's, "domain" [0, 1], and "weights" none; of an opaque
 * shape, "color" is a light grey by default. Their other keys are required. Directions need not be unit vectors. No number may
 * be larger than 1e18, so that its square is finite in single precision.
 */
#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

/* Reads and checks the file at `path`. On failure returns false, with one line "PATH: place: what to mend" in `message`, and
 * nothing to free. */
bool scene_load(const char *path, demo_scene *scene, char *message, size_t size);

/* Reads and checks `length` bytes of JSON in the same way. Messages call them `name`. */
bool scene_parse(const char *text, size_t length, const char *name, demo_scene *scene, char *message, size_t size);

/* Frees what scene_load or scene_parse allocated, and leaves the scene empty. */
void scene_free(demo_scene *scene);

#endif
