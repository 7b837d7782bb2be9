/* What a frame makes of sources for the uniform block, by kind. */
#ifndef PACKED_H
#define PACKED_H

#include "model/sources.h"

#include <string.h>

/* The block of source `index` of the list that ew_sources_desc calls `list`. */
static inline const void *packed_block(const ew_sources *sources, const char *list, size_t index)
{
    const char *block = sources->data;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        size_t size = ew_kind_units(ew_kinds[kind], sources->has_glow) * sizeof(ew_vec4);
        if (strcmp(ew_kinds[kind]->list_name, list) == 0) return block + index * size;
        block += sources->counts[kind] * size;
    }
    return NULL;
}

static inline const struct ew_point_block *packed_point(const ew_sources *sources, size_t index)
{
    return packed_block(sources, "points", index);
}

static inline const struct ew_line_block *packed_line(const ew_sources *sources, size_t index)
{
    return packed_block(sources, "lines", index);
}

static inline const struct ew_torus_block *packed_torus(const ew_sources *sources, size_t index)
{
    return packed_block(sources, "tori", index);
}

static inline const struct ew_curve_block *packed_curve(const ew_sources *sources, size_t index)
{
    return packed_block(sources, "curves", index);
}

static inline const struct ew_path_block *packed_path(const ew_sources *sources, size_t index)
{
    return packed_block(sources, "paths", index);
}

/* The pieces of weights, which lie behind all blocks. */
static inline const struct ew_weight_block *packed_weights(const ew_sources *sources)
{
    return (const void *)((const ew_vec4 *)sources->data + sources->weight_units);
}

#endif
