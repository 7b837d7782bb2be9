/*
 * Changes to one part of a scene file's text.
 */
#ifndef SCENE_EDIT_H
#define SCENE_EDIT_H

#include "scene_part.h"

#include <stdbool.h>

/* Whether the file has this member of the part. */
bool scene_edit_has(const char *text, scene_part part, const char *key);

/* Each returns the text with a member of the part, such as "core", set to the number or to the three numbers, and added where
 * it is missing. The caller frees it; NULL where memory is exhausted. */
char *scene_edit_set_number(const char *text, scene_part part, const char *key, double number);
char *scene_edit_set_vector(const char *text, scene_part part, const char *key, const double vector[3]);

/* Likewise, with one vector of a member that is a list of them. */
char *scene_edit_set_element(const char *text, scene_part part, const char *key, size_t element, const double vector[3]);

/* Writes what the file calls the part: its name, or else its list and its index. */
void scene_edit_title(const char *text, scene_part part, char *title, size_t size);

#endif
