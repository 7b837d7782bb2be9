/* Tori: see source_kind.h. */
#include "random_numbers.h"
#include "source_kinds.h"
#include "vector.h"

enum { SEED_COUNT = 9 };

/* ---- The reference ------------------------------------------------------------------------------------------------------ */

static double radius_of(const reference_source *source)
{
    const ew_torus *torus = source->desc;
    return torus->radius;
}

static double extent(const void *source)
{
    const ew_torus *torus = source;
    return torus->radius;
}

static nearest_point nearest(const reference_source *source, const double point[3])
{
    nearest_point result = {0};
    double from[3], radial[3], radius = radius_of(source);
    vector_subtract(point, source->position, from);
    double height = vector_dot(from, source->axis);
    vector_add_scaled(from, -height, source->axis, radial);
    double distance_from_axis = vector_length(radial);
    /* On the axis all of the circle is equally near; leaving the radial part at 0 then is right by symmetry. */
    double scale = distance_from_axis > 0 ? (distance_from_axis - radius) / distance_from_axis : 0;
    for (int i = 0; i < 3; i++)
        result.offset[i] = radial[i] * scale + source->axis[i] * height;
    result.distance = hypot(distance_from_axis - radius, height);
    return result;
}

static void seed(const reference_source *source, int number, double result[3])
{
    const double *axis = source->axis;
    double right[3] = {0}, up[3], norm, angle = 2 * M_PI * number / SEED_COUNT;
    int smallest = fabs(axis[0]) < fabs(axis[1]) ? 0 : 1;
    if (fabs(axis[2]) < fabs(axis[smallest])) smallest = 2;
    right[smallest] = 1;
    vector_add_scaled(right, -vector_dot(right, axis), axis, right);
    norm = vector_length(right);
    for (int i = 0; i < 3; i++)
        right[i] /= norm;
    vector_cross(axis, right, up);
    vector_add_scaled(source->position, radius_of(source) * cos(angle), right, result);
    vector_add_scaled(result, radius_of(source) * sin(angle), up, result);
}

/* The distance has a kink where the ray meets the axis. */
static bool kink(const reference_source *source, const double direction[3], double *x)
{
    double across[3];
    vector_add_scaled(direction, -vector_dot(direction, source->axis), source->axis, across);
    double square = vector_dot(across, across);
    *x = vector_dot(across, source->position) / square;
    return square > 0;
}

/* ---- Random scenes ------------------------------------------------------------------------------------------------------ */

static void place(const void *source, const source_view *view, double u, double result[3])
{
    const ew_torus *torus = source;
    double axis[3], right[3], up[3];
    (void)view;
    vector_normalize(torus->axis, axis);
    double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0};
    vector_cross(axis, other, right);
    vector_normalize(right, right);
    vector_cross(axis, right, up);
    vector_add_scaled(torus->center, torus->radius * cos(2 * M_PI * u), right, result);
    vector_add_scaled(result, torus->radius * sin(2 * M_PI * u), up, result);
}

static void write(scene_maker *maker, bool first, bool weighted)
{
    double center[3], axis[3], across[3], radial[3], radius = maker_source_extent(maker);
    (void)weighted;
    maker_source_place(maker, first, center);
    maker_direction(maker, axis);
    maker_direction(maker, across);
    if (maker_chance(maker, 0.1)) { /* seen nearly along its axis */
        vector_add_scaled(maker->forward, maker_magnitude(maker, 1e-5, 1e-1), across, axis);
        maker_direction(maker, across);
    }
    vector_cross(axis, across, radial);
    vector_normalize(radial, radial);
    vector_add_scaled(center, -radius, radial, center);
    maker_write_vector(maker, "center", center);
    maker_write_vector(maker, "axis", axis);
    fprintf(maker->file, "\"radius\": %.17g, ", radius);
}

/* ---- Hostile input ------------------------------------------------------------------------------------------------------ */

static void make(const random_place *at, void *source, double *weights, double (*points)[3])
{
    ew_torus *torus = source;
    (void)weights, (void)points;
    random_position(at, torus->center);
    random_direction(at, torus->axis);
    torus->radius =
        (at->end - at->start) * (at->extreme ? random_power_of_ten(at->random, -9, 3) : random_between(at->random, 0, 1));
    if (at->extreme && random_chance(at->random, 0.1)) torus->radius = 0;
    random_light(at, &torus->coefficient, torus->color);
}

const source_kind torus_kind = {
    .name = "torus",
    .list_name = "tori",
    SOURCE_KIND_LAYOUT(ew_torus, tori, torus_count, center),
    .direction_offsets = {offsetof(ew_torus, axis)},
    .direction_count = 1,
    .has_axis = true,
    .extent = extent,
    .nearest = nearest,
    .seed = seed,
    .seed_count = SEED_COUNT,
    .kink = kink,
    .place = place,
    .scene_share = 0.16,
    .world_scene_name = "world torus",
    .world_scene_share = 0.12,
    .write = write,
    .make = make,
};
