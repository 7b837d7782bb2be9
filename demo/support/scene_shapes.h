/*
 * The opaque shapes and the media of a scene file: a part of scene_file.c.
 */
#ifndef SCENE_SHAPES_H
#define SCENE_SHAPES_H

#include "json_reader.h"
#include "scene.h"

void scene_read_opaque(json_reader *r, const json_value *root, demo_scene *scene);

void scene_read_media(json_reader *r, const json_value *root, demo_scene *scene);

#endif
