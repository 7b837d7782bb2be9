/* Paths written in another way: see path_forms.h. */
#include "path_forms.h"
#include "path_parts.h"
#include "source_kinds.h"
#include "vector.h"

#include <stdlib.h>
#include <string.h>

/* The library's lists are lists of constants; those of a copy are not. */
static ew_path *paths_of(const ew_sources_desc *copy)
{
    return (ew_path *)copy->paths;
}

static bool compare(equation_stage *s, const char *relation, const ew_sources_desc *sources, const luminance_sum *whole)
{
    luminance_sum other = {{0}, {0}};
    ew_frame_desc frame = equation_frame(s);
    if (!equation_add_picture(s, sources, &frame, s->depth, 1, &other)) return false;
    equation_compare(s, relation, whole, &other, NULL);
    return true;
}

/* ---- From end to start -------------------------------------------------------------------------------------------------- */

/* What is closed begins at its first point, but for a B-spline, which begins at the joint before that. */
static void reverse_points(ew_path *path)
{
    double(*points)[3] = (double(*)[3])path->points;
    bool keeps_first = path->is_closed && path->kind != EW_PATH_BSPLINE;
    for (size_t i = keeps_first, k = path->point_count - 1; i < k; i++, k--) {
        double point[3];
        vector_copy(points[i], point);
        vector_copy(points[k], points[i]);
        vector_copy(point, points[k]);
    }
}

/* `weights` has room for those of all paths. */
static void reverse_paths(ew_sources_desc *sources, double *weights)
{
    for (size_t i = 0; i < sources->path_count; i++) {
        ew_path *path = &paths_of(sources)[i];
        reverse_points(path);
        for (size_t k = 0; k < path->weight_count; k++)
            weights[k] = path->weights[path->weight_count - 1 - k];
        if (path->weight_count > 0) path->weights = weights;
        weights += path->weight_count;
    }
}

bool paths_reverse(equation_stage *s, const luminance_sum *whole)
{
    ew_sources_desc sources;
    size_t weight_count = 0;
    if (!copy_source_lists(&s->scene->sources, &sources)) return false;
    for (size_t i = 0; i < sources.path_count; i++)
        weight_count += sources.paths[i].weight_count;
    double *weights = malloc(weight_count * sizeof *weights + 1);
    if (weights) reverse_paths(&sources, weights);
    bool ok = weights && compare(s, "paths reversed", &sources, whole);
    free_source_lists(&sources);
    free(weights);
    return ok;
}

/* ---- B-splines ---------------------------------------------------------------------------------------------------------- */

/* Each span has the same share of the parameter in both, so the weights stay. */
static bool make_bezier(ew_path *path)
{
    size_t spans = path_span_count(path);
    double(*points)[3] = malloc((3 * spans + 1) * sizeof *points);
    if (!points) return false;
    for (size_t span = 0; span < spans; span++) {
        double cubic[4][3];
        path_span(path, span, cubic);
        memcpy(points[3 * span], cubic, sizeof cubic);
    }
    free((void *)path->points);
    path->points = (const double(*)[3])points;
    path->point_count = 3 * spans + 1;
    path->kind = EW_PATH_BEZIER;
    return true;
}

bool splines_are_beziers(equation_stage *s, const luminance_sum *whole)
{
    ew_sources_desc sources;
    if (!copy_source_lists(&s->scene->sources, &sources)) return false;
    bool ok = true;
    for (size_t i = 0; ok && i < sources.path_count; i++) {
        ew_path *path = &paths_of(&sources)[i];
        if (path->kind == EW_PATH_BSPLINE && !path->is_closed) ok = make_bezier(path);
    }
    ok = ok && compare(s, "B-splines as Bezier chains", &sources, whole);
    free_source_lists(&sources);
    return ok;
}
