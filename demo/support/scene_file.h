/*
 * The scene file, which docs/scene-format.md describes.
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

/* Returns the bytes of a file that is not too large for a scene, which the caller frees, and a 0 behind them; NULL, with a
 * message, on failure. */
char *scene_read_text(const char *path, size_t *length, char *message, size_t size);

/* Frees what scene_load or scene_parse allocated, and leaves the scene empty. */
void scene_free(demo_scene *scene);

#endif
