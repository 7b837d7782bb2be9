/*
 * One part of a scene, out of the lists of all kinds: a source, an opaque shape or a medium.
 */
#ifndef SCENE_PART_H
#define SCENE_PART_H

#include "scene.h"
#include "source_light.h"

#include <stdbool.h>

/* First those of sources, in the order of the scene file's lists. */
typedef enum part_kind { PART_POINT, PART_LINE, PART_TORUS, PART_CURVE, PART_PATH, PART_OPAQUE, PART_MEDIUM } part_kind;
enum { PART_KIND_COUNT = PART_MEDIUM + 1 };

static inline bool part_is_source(part_kind kind)
{
    return kind < PART_OPAQUE;
}

typedef struct scene_part {
    part_kind kind;
    size_t index; /* in the kind's list */
} scene_part;

/* The list's key in the scene file. */
const char *scene_part_list(part_kind kind);

size_t scene_part_count(const demo_scene *scene, part_kind kind);

/* All parts have numbers, from 0 on, in the order of the lists. Without a part of that number, returns false. */
size_t scene_part_total(const demo_scene *scene);
size_t scene_part_number(const demo_scene *scene, scene_part part);
bool scene_part_of_number(const demo_scene *scene, size_t number, scene_part *part);

/* Of a source. */
source_light scene_part_light(const demo_scene *scene, scene_part part);

#endif
