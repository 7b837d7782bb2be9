/*
 * A scene as the text of a scene file, which docs/scene-format.md describes.
 */
#ifndef SCENE_WRITE_H
#define SCENE_WRITE_H

#include "scene.h"

/* Returns the text, which the caller frees; NULL where memory is exhausted. Reading it gives the same scene: numbers keep all
 * their digits. Curves are written by their polynomials, and every source with its own colour;
 * a scene knows no names or comments. */
char *scene_write(const demo_scene *scene);

#endif
