/* Lines: see source_kind.h. */
#include "source_kinds.h"
#include "vector.h"

static nearest_point nearest(const reference_source *source, const double point[3])
{
    nearest_point result = {0};
    double from[3];
    vector_subtract(point, source->position, from);
    vector_add_scaled(from, -vector_dot(from, source->axis), source->axis, result.offset);
    result.distance = vector_length(result.offset);
    return result;
}

/* About the line's point that is nearest to the middle of the view. */
static void place(const void *source, const source_view *view, double u, double result[3])
{
    const ew_line *line = source;
    double direction[3], to_middle[3];
    vector_normalize(line->direction, direction);
    vector_subtract(view->middle, line->position, to_middle);
    double reach = (2 * u - 1) * view->length;
    vector_add_scaled(line->position, vector_dot(to_middle, direction) + reach, direction, result);
}

static void write(scene_maker *maker, bool first, bool weighted)
{
    double position[3], direction[3], along[3];
    (void)weighted;
    maker_source_place(maker, first, position);
    maker_direction(maker, direction);
    if (maker_chance(maker, 0.15)) { /* nearly along the view */
        vector_add_scaled(maker->forward, maker_magnitude(maker, 1e-5, 1e-1), direction, along);
        vector_copy(along, direction);
    }
    vector_add_scaled(position, maker_between(maker, -1, 1) * maker->distance, direction, position);
    maker_write_vector(maker, "position", position);
    maker_write_vector(maker, "direction", direction);
}

static void make(const random_place *at, void *source, double *weights, double (*points)[3])
{
    ew_line *line = source;
    (void)weights, (void)points;
    random_position(at, line->position);
    random_direction(at, line->direction);
    random_light(at, &line->coefficient, line->color);
}

const source_kind line_kind = {
    .name = "line",
    .list_name = "lines",
    SOURCE_KIND_LAYOUT(ew_line, lines, line_count, position),
    .direction_offsets = {offsetof(ew_line, direction)},
    .direction_count = 1,
    .has_closed_form = true,
    .has_axis = true,
    .is_endless = true,
    .nearest = nearest,
    .place = place,
    .scene_share = 0.08,
    .world_scene_name = "world line",
    .world_scene_share = 0.1,
    .write = write,
    .make = make,
};
