/*
 * The kinds of sources and what can be done with sources of any kind. A new kind is one line in SOURCE_KINDS and one file in
 * kinds/.
 */
#ifndef SOURCE_KINDS_H
#define SOURCE_KINDS_H

#include "source_kind.h"

/* X(NAME, name) for each kind, in the order in which the shares of a luminance and the sources of random scenes come. */
#define SOURCE_KINDS(X)                                                                                                        \
    X(POINT, point)                                                                                                            \
    X(LINE, line)                                                                                                              \
    X(TORUS, torus)                                                                                                            \
    X(CURVE, curve)                                                                                                            \
    X(PATH, path)

enum {
#define KIND_INDEX(NAME, name) KIND_##NAME,
    SOURCE_KINDS(KIND_INDEX)
#undef KIND_INDEX
        SOURCE_KIND_COUNT
};

#define KIND_ROW(NAME, name) extern const source_kind name##_kind;
SOURCE_KINDS(KIND_ROW)
#undef KIND_ROW

extern const source_kind *const source_kinds[SOURCE_KIND_COUNT];

size_t source_count(const source_kind *kind, const ew_sources_desc *sources);
size_t source_count_of_all_kinds(const ew_sources_desc *sources);
const void *source_at(const source_kind *kind, const ew_sources_desc *sources, size_t index);
const double *source_position(const source_kind *kind, const void *source);
const double *source_direction(const source_kind *kind, const void *source, size_t index);
source_light source_light_of(const source_kind *kind, const void *source);

void set_source_list(const source_kind *kind, ew_sources_desc *sources, const void *list);
void set_source_count(const source_kind *kind, ew_sources_desc *sources, size_t count);
void set_mix_count(const source_kind *kind, ew_mix *mix, size_t count);

/* Calls `change` for each source's position and directions; the lists must be the caller's own. */
typedef void vector_change(const void *user, double vector[3]);
void change_sources(ew_sources_desc *sources, vector_change *position, vector_change *direction, const void *user);

/* Copies the lists and the points that paths point to, but not the weights. Returns false, and nothing to free, where memory is
 * exhausted. */
bool copy_source_lists(const ew_sources_desc *sources, ew_sources_desc *copy);
void free_source_lists(ew_sources_desc *copy);

#endif
