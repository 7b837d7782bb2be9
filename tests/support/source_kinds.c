/* Sources of any kind: see source_kinds.h. */
#include "source_kinds.h"

#include <stdlib.h>
#include <string.h>

const source_kind *const source_kinds[SOURCE_KIND_COUNT] = {
#define KIND_ADDRESS(NAME, name) &name##_kind,
    SOURCE_KINDS(KIND_ADDRESS)
#undef KIND_ADDRESS
};

#define ASSERT_LIGHT_MEMBER(type, member)                                                                                      \
    _Static_assert(offsetof(type, member) - offsetof(type, coefficient) == offsetof(source_light, member),                     \
                   #type " has " #member " elsewhere than source_light")
#define ASSERT_LIGHT(type)                                                                                                     \
    ASSERT_LIGHT_MEMBER(type, color);                                                                                          \
    ASSERT_LIGHT_MEMBER(type, brightness);                                                                                     \
    ASSERT_LIGHT_MEMBER(type, core);                                                                                           \
    ASSERT_LIGHT_MEMBER(type, reach);                                                                                          \
    ASSERT_LIGHT_MEMBER(type, sharpness)
ASSERT_LIGHT(ew_point);
ASSERT_LIGHT(ew_line);
ASSERT_LIGHT(ew_torus);
ASSERT_LIGHT(ew_curve);
ASSERT_LIGHT(ew_path);

/* ---- Reading ------------------------------------------------------------------------------------------------------------ */

static const void *source_list(const source_kind *kind, const ew_sources_desc *sources)
{
    const void *list;
    memcpy(&list, (const char *)sources + kind->list_offset, sizeof list);
    return list;
}

size_t source_count(const source_kind *kind, const ew_sources_desc *sources)
{
    return *(const size_t *)(const void *)((const char *)sources + kind->count_offset);
}

size_t source_count_of_all_kinds(const ew_sources_desc *sources)
{
    size_t count = 0;
    for (int kind = 0; kind < SOURCE_KIND_COUNT; kind++)
        count += source_count(source_kinds[kind], sources);
    return count;
}

const void *source_at(const source_kind *kind, const ew_sources_desc *sources, size_t index)
{
    return (const char *)source_list(kind, sources) + index * kind->size;
}

static const double *number_at(const void *source, size_t offset)
{
    return (const double *)(const void *)((const char *)source + offset);
}

const double *source_position(const source_kind *kind, const void *source)
{
    return number_at(source, kind->position_offset);
}

const double *source_direction(const source_kind *kind, const void *source, size_t index)
{
    return number_at(source, kind->direction_offsets[index]);
}

source_light source_light_of(const source_kind *kind, const void *source)
{
    source_light light;
    memcpy(&light, number_at(source, kind->light_offset), sizeof light);
    return light;
}

static double (*points_of(const source_kind *kind, const void *source))[3]
{
    double(*points)[3];
    memcpy(&points, (const char *)source + kind->points_offset, sizeof points);
    return points;
}

static size_t point_count_of(const source_kind *kind, const void *source)
{
    return *(const size_t *)(const void *)((const char *)source + kind->point_count_offset);
}

/* ---- Writing ------------------------------------------------------------------------------------------------------------ */

void set_source_list(const source_kind *kind, ew_sources_desc *sources, const void *list)
{
    memcpy((char *)sources + kind->list_offset, &list, sizeof list);
}

void set_source_count(const source_kind *kind, ew_sources_desc *sources, size_t count)
{
    memcpy((char *)sources + kind->count_offset, &count, sizeof count);
}

void set_mix_count(const source_kind *kind, ew_mix *mix, size_t count)
{
    memcpy((char *)mix + kind->mix_count_offset, &count, sizeof count);
}

void change_sources(ew_sources_desc *sources, vector_change *position, vector_change *direction, const void *user)
{
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        for (size_t i = 0; i < source_count(kind, sources); i++) {
            /* The library's lists are lists of constants; these are the caller's. */
            const void *source = source_at(kind, sources, i);
            if (position && kind->has_points)
                for (size_t j = 0; j < point_count_of(kind, source); j++)
                    position(user, points_of(kind, source)[j]);
            else if (position)
                position(user, (double *)source_position(kind, source));
            for (size_t j = 0; direction && j < kind->direction_count; j++)
                direction(user, (double *)source_direction(kind, source, j));
        }
    }
}

/* Gives each source of a copied list its own points. On failure some have none. */
static bool copy_points(const source_kind *kind, ew_sources_desc *copy)
{
    bool ok = true;
    for (size_t i = 0; kind->has_points && i < source_count(kind, copy); i++) {
        char *source = (char *)source_list(kind, copy) + i * kind->size;
        size_t size = point_count_of(kind, source) * sizeof(double[3]);
        void *points = malloc(size + 1);
        if (points) memcpy(points, points_of(kind, source), size);
        memcpy(source + kind->points_offset, &points, sizeof points);
        ok = ok && points;
    }
    return ok;
}

bool copy_source_lists(const ew_sources_desc *sources, ew_sources_desc *copy)
{
    bool ok = true;
    *copy = *sources;
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        size_t size = source_count(kind, sources) * kind->size;
        void *list = malloc(size + 1);
        if (list && size > 0) memcpy(list, source_list(kind, sources), size);
        set_source_list(kind, copy, list);
        ok = list && copy_points(kind, copy) && ok;
    }
    if (!ok) free_source_lists(copy);
    return ok;
}

void free_source_lists(ew_sources_desc *copy)
{
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        const void *list = source_list(kind, copy);
        for (size_t i = 0; list && kind->has_points && i < source_count(kind, copy); i++)
            free(points_of(kind, source_at(kind, copy, i)));
        free((void *)list);
    }
}
