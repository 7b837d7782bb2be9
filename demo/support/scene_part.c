/* One part of a scene: see scene_part.h. */
#include "scene_part.h"

const char *scene_part_list(part_kind kind)
{
    static const char *const lists[PART_KIND_COUNT] = {
        [PART_POINT] = "points", [PART_LINE] = "lines",    [PART_TORUS] = "tori",  [PART_CURVE] = "curves",
        [PART_PATH] = "paths",   [PART_OPAQUE] = "opaque", [PART_MEDIUM] = "media"};
    return lists[kind];
}

size_t scene_part_count(const demo_scene *scene, part_kind kind)
{
    const ew_sources_desc *sources = &scene->sources;
    const size_t counts[PART_KIND_COUNT] = {
        [PART_POINT] = sources->point_count, [PART_LINE] = sources->line_count, [PART_TORUS] = sources->torus_count,
        [PART_CURVE] = sources->curve_count, [PART_PATH] = sources->path_count, [PART_OPAQUE] = scene->opaque_count,
        [PART_MEDIUM] = scene->medium_count};
    return counts[kind];
}

/* How many parts there are in the lists before that of this kind. */
static size_t count_before(const demo_scene *scene, int kind)
{
    size_t count = 0;
    for (int before = 0; before < kind; before++)
        count += scene_part_count(scene, (part_kind)before);
    return count;
}

size_t scene_part_total(const demo_scene *scene)
{
    return count_before(scene, PART_KIND_COUNT);
}

size_t scene_part_number(const demo_scene *scene, scene_part part)
{
    return count_before(scene, (int)part.kind) + part.index;
}

bool scene_part_of_number(const demo_scene *scene, size_t number, scene_part *part)
{
    for (int kind = 0; kind < PART_KIND_COUNT; kind++) {
        size_t count = scene_part_count(scene, (part_kind)kind);
        if (number < count) {
            *part = (scene_part){(part_kind)kind, number};
            return true;
        }
        number -= count;
    }
    return false;
}

source_light scene_part_light(const demo_scene *scene, scene_part part)
{
    const ew_sources_desc *sources = &scene->sources;
    switch (part.kind) {
    case PART_POINT:
        return SOURCE_LIGHT(&sources->points[part.index]);
    case PART_LINE:
        return SOURCE_LIGHT(&sources->lines[part.index]);
    case PART_TORUS:
        return SOURCE_LIGHT(&sources->tori[part.index]);
    case PART_CURVE:
        return SOURCE_LIGHT(&sources->curves[part.index]);
    case PART_PATH:
        return SOURCE_LIGHT(&sources->paths[part.index]);
    case PART_OPAQUE:
    case PART_MEDIUM:
        break;
    }
    return (source_light){0};
}
