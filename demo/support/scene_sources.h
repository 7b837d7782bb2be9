/*
 * The sources of a scene file: a part of scene_file.c, with one row a kind.
 */
#ifndef SCENE_SOURCES_H
#define SCENE_SOURCES_H

#include "energywave.h"
#include "json_reader.h"

typedef struct scene_source_kind {
    const char *key; /* of the kind's list */
    /* Reads the kind's list. The reader's context is the scene, all but its sources already read. */
    void (*read)(json_reader *r, const json_value *root, ew_sources_desc *sources);
} scene_source_kind;

enum { SCENE_SOURCE_KIND_COUNT = 5 };
extern const scene_source_kind scene_source_kinds[SCENE_SOURCE_KIND_COUNT];

#endif
