/* Paths: see source_kind.h. */
#include "path_parts.h"
#include "random_numbers.h"
#include "source_kinds.h"
#include "vector.h"

#include <string.h>

/* ---- Random scenes ------------------------------------------------------------------------------------------------------ */

enum { MAX_POINTS = 31 };

static void place(const void *source, const source_view *view, double u, double result[3])
{
    const ew_path *path = source;
    size_t count = path_span_count(path), span = (size_t)(u * (double)count);
    double cubic[4][3];
    (void)view;
    if (span >= count) span = count - 1;
    path_span(path, span, cubic);
    double t = u * (double)count - (double)span, s = 1 - t;
    for (int i = 0; i < 3; i++)
        result[i] =
            s * s * s * cubic[0][i] + 3 * s * s * t * cubic[1][i] + 3 * s * t * t * cubic[2][i] + t * t * t * cubic[3][i];
}

/* Steps of about the same length, some of them straight on; and, unless there are weights, some of them none, or back to where
 * the one before came from: there, which weight counts would be undefined. */
static void random_points(scene_maker *maker, double extent, bool weighted, double points[][3], size_t count)
{
    double step[3] = {0};
    for (size_t i = 0; i < count; i++) {
        double choice = maker_between(maker, 0, 1), previous[3];
        vector_copy(step, previous);
        maker_offset(maker, extent, step);
        for (int k = 0; k < 3 && i > 1; k++)
            step[k] = choice < 0.08 ? previous[k] : choice > 0.12 || weighted ? step[k] : choice > 0.1 ? 0 : -previous[k];
        for (int k = 0; k < 3; k++)
            points[i][k] = i == 0 ? 0 : points[i - 1][k] + step[k];
    }
}

static size_t random_point_count(scene_maker *maker, ew_path_kind kind, bool is_closed)
{
    size_t count = 2 + random_index(&maker->random, maker_chance(maker, 0.1) ? 24 : 6);
    if (kind == EW_PATH_BEZIER) return 1 + 3 * (1 + count % 3);
    return count == 2 && (is_closed || kind == EW_PATH_BSPLINE) ? 3 : count;
}

/* The library takes no more than 600 quadratic pieces for a path. Some 200 are as close as it wants to cubics, whose third
 * differences are up to 16 steps long, if the core is as wide as this. */
static double least_core(const ew_path *path, double step)
{
    bool is_cubic = path->kind == EW_PATH_BEZIER || path->kind == EW_PATH_CATMULL_ROM;
    double pieces = 200 / (double)path_span_count(path);
    return is_cubic ? 230 * step / (pieces * pieces * pieces) : 0;
}

static void write_path(scene_maker *maker, const ew_path *path)
{
    static const char *const names[] = {"polyline", "bspline", "bezier", "catmull_rom"};
    fprintf(maker->file, "\"kind\": \"%s\", \"points\": [", names[path->kind]);
    for (size_t i = 0; i < path->point_count; i++)
        fprintf(maker->file, "%s[%.17g, %.17g, %.17g]", i ? ", " : "", path->points[i][0], path->points[i][1],
                path->points[i][2]);
    fprintf(maker->file, "], %s", path->is_closed ? "\"closed\": true, " : "");
}

static void write(scene_maker *maker, bool first, bool weighted)
{
    double points[MAX_POINTS][3], position[3], on_path[3];
    ew_path path = {.kind = (ew_path_kind)random_index(&maker->random, 4), .points = (const double(*)[3])points};
    path.is_closed = maker_chance(maker, 0.3) && path.kind != EW_PATH_BEZIER;
    path.point_count = random_point_count(maker, path.kind, path.is_closed);
    double extent = maker_source_extent(maker);
    random_points(maker, extent, weighted, points, path.point_count);
    maker->least_core = least_core(&path, extent);
    maker_source_place(maker, first, position);
    /* Joints and ends are looked at more often than their share. */
    double u = maker_between(maker, 0, 1), spans = (double)path_span_count(&path);
    place(&path, NULL, maker_chance(maker, 0.3) ? round(u * spans) / spans : u, on_path);
    for (size_t i = 0; i < path.point_count; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] += position[k] - on_path[k];
    write_path(maker, &path);
    if (weighted) maker_write_weights(maker, path.is_closed);
}

/* ---- Hostile input ------------------------------------------------------------------------------------------------------ */

/* Brings points to where a path degenerates: on one another, back to where it was, straight on, or nearly so. */
static void degenerate(uint64_t *random, double points[][3], size_t count)
{
    for (size_t k = 2; k < count; k++) {
        double along = random_between(random, -1, 2), close = random_power_of_ten(random, -12, 0);
        size_t choice = random_index(random, 6);
        for (int i = 0; i < 3; i++) {
            double step = points[k - 1][i] - points[k - 2][i];
            if (choice == 0) points[k][i] = points[k - 1][i] + along * step;
            if (choice == 1) points[k][i] = points[k - 2][i];
            if (choice == 2) points[k][i] = points[k - 1][i] + close * (points[k][i] - points[k - 1][i]);
        }
    }
}

static void make_weights(const random_place *at, ew_path *path, double *weights)
{
    path->weights = weights;
    path->weight_count = 1 + random_index(at->random, MAX_RANDOM_WEIGHTS);
    for (size_t i = 0; i < MAX_RANDOM_WEIGHTS; i++)
        weights[i] = at->extreme ? random_power_of_ten(at->random, -9, 3) * (double)random_index(at->random, 3)
                                 : random_unit(at->random);
}

static void make(const random_place *at, void *source, double *weights, double (*points)[3])
{
    ew_path *path = source;
    path->points = (const double(*)[3])points;
    path->kind = (ew_path_kind)random_index(at->random, 4);
    path->is_closed = path->kind != EW_PATH_BEZIER && random_chance(at->random, 0.3);
    path->point_count = 3 + random_index(at->random, MAX_RANDOM_POINTS - 2);
    if (path->kind == EW_PATH_BEZIER) path->point_count = 4 + 3 * random_index(at->random, MAX_RANDOM_POINTS / 3);
    if (path->kind == EW_PATH_POLYLINE && !path->is_closed && random_chance(at->random, 0.3)) path->point_count = 2;
    for (size_t k = 0; k < path->point_count; k++)
        random_position(at, points[k]);
    if (at->extreme) degenerate(at->random, points, path->point_count);
    /* Of thin cores, a path may need more pieces than the library takes. */
    if (!at->extreme) path->core = 0.1 * (at->end - at->start);
    random_light(at, &path->coefficient, path->color);
    if (weights) make_weights(at, path, weights);
}

static size_t numbers(void *source, number_run runs[MAX_SOURCE_RUNS])
{
    ew_path *path = source;
    /* The library's points and weights are constants; these are the caller's. */
    runs[0] = (number_run){(double *)path->points, 3 * path->point_count};
    runs[1] = (number_run){&path->coefficient, sizeof(source_light) / sizeof(double)};
    runs[2] = (number_run){(double *)path->weights, path->weight_count};
    return 3;
}

const source_kind path_kind = {
    .name = "path",
    .list_name = "paths",
    SOURCE_KIND_LAYOUT(ew_path, paths, path_count, points),
    .has_points = true,
    .points_offset = offsetof(ew_path, points),
    .point_count_offset = offsetof(ew_path, point_count),
    .place = place,
    .world_scene_name = "world path",
    .world_scene_share = 0.24,
    .write = write,
    .make = make,
    .numbers = numbers,
};
