/* Points: see source_kind.h. */
#include "source_kinds.h"
#include "vector.h"

static nearest_point nearest(const reference_source *source, const double point[3])
{
    nearest_point result = {0};
    vector_subtract(point, source->position, result.offset);
    result.distance = vector_length(result.offset);
    return result;
}

static void place(const void *source, const source_view *view, double u, double result[3])
{
    const ew_point *point = source;
    (void)view, (void)u;
    vector_copy(point->position, result);
}

static void write(scene_maker *maker, bool first, bool weighted)
{
    double position[3];
    (void)weighted;
    maker_source_place(maker, first, position);
    maker_write_vector(maker, "position", position);
}

static void make(const random_place *at, void *source, double *weights, double (*points)[3])
{
    ew_point *point = source;
    (void)weights, (void)points;
    random_position(at, point->position);
    random_light(at, &point->coefficient, point->color);
}

const source_kind point_kind = {
    .name = "point",
    .list_name = "points",
    SOURCE_KIND_LAYOUT(ew_point, points, point_count, position),
    .has_closed_form = true,
    .nearest = nearest,
    .place = place,
    .scene_share = 0.06,
    .world_scene_name = "world point",
    .world_scene_share = 0.08,
    .write = write,
    .make = make,
};
