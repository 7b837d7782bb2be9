/*
 * One source out of the lists of all kinds.
 */
#ifndef SOURCE_PART_H
#define SOURCE_PART_H

#include "energywave.h"
#include "source_light.h"

/* In the order of the scene file's lists. */
typedef enum source_kind { SOURCE_POINT, SOURCE_LINE, SOURCE_TORUS, SOURCE_CURVE, SOURCE_PATH } source_kind;
enum { SOURCE_KIND_COUNT = SOURCE_PATH + 1 };

typedef struct source_part {
    source_kind kind;
    size_t index; /* in the kind's list */
} source_part;

size_t source_part_count(const ew_sources_desc *sources, source_kind kind);

source_light source_part_light(const ew_sources_desc *sources, source_part part);

#endif
