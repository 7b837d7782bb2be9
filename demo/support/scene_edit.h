/*
 * Changes to one source of a scene file's text.
 */
#ifndef SCENE_EDIT_H
#define SCENE_EDIT_H

#include "scene.h"
#include "source_part.h"

#include <stdbool.h>

/* Whether the file has this member of the source. */
bool scene_edit_has(const char *text, source_part part, const char *key);

/* How many positions of the source can be moved. `text` is what the scene was read from. */
size_t scene_edit_point_count(const demo_scene *scene, const char *text, source_part part);

/* Such a position. */
void scene_edit_point(const demo_scene *scene, source_part part, size_t point, double position[3]);

/* Returns the text with the position moved, rounded to multiples of `step`. The caller frees it; NULL where memory is
 * exhausted. */
char *scene_edit_move_point(const char *text, source_part part, size_t point, const double position[3], double step);

/* Returns the text with a member of the source, such as "core", set to the number, and added where it is missing. Likewise. */
char *scene_edit_set_number(const char *text, source_part part, const char *key, double number);

/* Writes what the file calls the source: its name, or else its list and its index. */
void scene_edit_title(const char *text, source_part part, char *title, size_t size);

#endif
