/* The parts of a path: see path_parts.h. */
#include "path_parts.h"
#include "reference_arc.h"
#include "reference_weight.h"
#include "vector.h"

#include <stdlib.h>

/* How close quadratic pieces are to a cubic one, in radii of the core. The joints between them are part of a path's definition:
 * beyond a bend's centre of curvature the field depends on where they are. So the library's pieces are the definition, and
 * these are the same by another formula. */
#define CUBIC_TOLERANCE 3e-4

enum { SEED_COUNT = 5, MAX_PIECES_OF_A_SPAN = 4096 };

/* ---- Spans -------------------------------------------------------------------------------------------------------------- */

size_t path_span_count(const ew_path *path)
{
    size_t n = path->point_count;
    switch (path->kind) {
    case EW_PATH_BSPLINE:
        return path->is_closed ? n : n - 2;
    case EW_PATH_BEZIER:
        return (n - 1) / 3;
    case EW_PATH_POLYLINE:
    case EW_PATH_CATMULL_ROM:
        break;
    }
    return path->is_closed ? n : n - 1;
}

/* Point i of a closed path, from -1 on, or of an open one, whose missing neighbours at the ends are mirrored. */
static void point_of(const ew_path *path, long i, double result[3])
{
    long n = (long)path->point_count;
    const double(*points)[3] = path->points;
    if (path->is_closed || (i >= 0 && i < n)) {
        vector_copy(points[(i + n) % n], result);
        return;
    }
    const double *end = i < 0 ? points[0] : points[n - 1], *next = i < 0 ? points[1] : points[n - 2];
    for (int k = 0; k < 3; k++)
        result[k] = 2 * end[k] - next[k];
}

/* The piece around a B-spline's point: from half way between its neighbour before and it to half way on. An open spline's
 * first and last pieces go to its ends. */
static void bspline_span(const ew_path *path, size_t span, double points[3][3])
{
    long n = (long)path->point_count, middle = (long)span + !path->is_closed;
    for (int k = 0; k < 3; k++)
        point_of(path, middle + k - 1, points[k]);
    for (int k = 0; k < 3; k++) {
        if (path->is_closed || middle > 1) points[0][k] = 0.5 * (points[0][k] + points[1][k]);
        if (path->is_closed || middle < n - 2) points[2][k] = 0.5 * (points[1][k] + points[2][k]);
    }
}

/* The span from point `span` on of a uniform Catmull-Rom spline. */
static void catmull_rom_span(const ew_path *path, size_t span, double cubic[4][3])
{
    double points[4][3];
    for (int k = 0; k < 4; k++)
        point_of(path, (long)span + k - 1, points[k]);
    for (int k = 0; k < 3; k++) {
        cubic[0][k] = points[1][k];
        cubic[1][k] = points[1][k] + (points[2][k] - points[0][k]) / 6;
        cubic[2][k] = points[2][k] - (points[3][k] - points[1][k]) / 6;
        cubic[3][k] = points[2][k];
    }
}

void path_span(const ew_path *path, size_t span, double cubic[4][3])
{
    double points[3][3];
    switch (path->kind) {
    case EW_PATH_CATMULL_ROM:
        catmull_rom_span(path, span, cubic);
        return;
    case EW_PATH_BEZIER:
        for (int k = 0; k < 4; k++)
            vector_copy(path->points[3 * span + (size_t)k], cubic[k]);
        return;
    case EW_PATH_BSPLINE:
        bspline_span(path, span, points);
        break;
    case EW_PATH_POLYLINE:
        point_of(path, (long)span, points[0]);
        point_of(path, (long)span + 1, points[2]);
        for (int k = 0; k < 3; k++)
            points[1][k] = 0.5 * (points[0][k] + points[2][k]);
        break;
    }
    for (int k = 0; k < 3; k++) {
        cubic[0][k] = points[0][k];
        cubic[1][k] = points[0][k] + 2 / 3.0 * (points[1][k] - points[0][k]);
        cubic[2][k] = points[2][k] + 2 / 3.0 * (points[1][k] - points[2][k]);
        cubic[3][k] = points[2][k];
    }
}

/* ---- Pieces ------------------------------------------------------------------------------------------------------------- */

static nearest_point nearest(const reference_source *source, const double point[3])
{
    const path_piece *piece = source->desc;
    double from[3];
    vector_subtract(source->position, point, from);
    return reference_nearest_of_arc(&piece->arc, from);
}

/* The weights lie along the whole path. */
static reference_weighting weigh(const reference_source *source, const nearest_point *nearest)
{
    const path_piece *piece = source->desc;
    const ew_path *path = piece->path;
    double u = piece->first_u + nearest->t * (piece->last_u - piece->first_u), largest = 1;
    for (size_t i = 0; i < path->weight_count; i++)
        largest = i == 0 ? path->weights[i] : fmax(largest, path->weights[i]);
    return (reference_weighting){
        .weight = reference_weight(path->weights, path->weight_count, u),
        .largest = largest,
        .span = reference_weight_span(path->weight_count, u),
    };
}

static void seed(const reference_source *source, int number, double result[3])
{
    const path_piece *piece = source->desc;
    double t = number / (SEED_COUNT - 1.0);
    vector_add_scaled(source->position, t, piece->arc.polynomial[1], result);
    vector_add_scaled(result, t * t, piece->arc.polynomial[2], result);
}

static double extent(const void *source)
{
    const path_piece *piece = source;
    return vector_length(piece->arc.polynomial[1]) + vector_length(piece->arc.polynomial[2]);
}

const source_kind path_piece_kind = {
    .name = "piece of a path",
    .size = sizeof(path_piece),
    .position_offset = offsetof(path_piece, arc.polynomial[0]),
    .extent = extent,
    .nearest = nearest,
    .weigh = weigh,
    .seed = seed,
    .seed_count = SEED_COUNT,
};

/* ---- Parts -------------------------------------------------------------------------------------------------------------- */

static bool reserve(path_parts *parts, size_t capacity)
{
    if (capacity <= parts->capacity) return true;
    path_piece *pieces = realloc(parts->pieces, capacity * sizeof *pieces);
    if (pieces) parts->pieces = pieces;
    path_joint *joints = realloc(parts->joints, capacity * sizeof *joints);
    if (joints) parts->joints = joints;
    if (!pieces || !joints) return false;
    parts->capacity = capacity;
    return true;
}

/* Equal parts of a cubic, each replaced by the quadratic that meets it at the ends and in the middle: of n parts the distance
 * at equal parameters is sqrt(3) / 36 n^3 times the third difference's length, at the most. */
static size_t piece_count_of(double cubic[4][3], bool is_cubic, double core)
{
    double difference[3];
    if (!is_cubic) return 1;
    for (int k = 0; k < 3; k++)
        difference[k] = cubic[3][k] - cubic[0][k] + 3 * (cubic[1][k] - cubic[2][k]);
    double count = ceil(cbrt(sqrt(3) / 36 * vector_length(difference) / (CUBIC_TOLERANCE * core)));
    return count < 1 ? 1 : count > MAX_PIECES_OF_A_SPAN ? MAX_PIECES_OF_A_SPAN : (size_t)count;
}

static double cubic_at(double cubic[4][3], int axis, double t)
{
    double c0 = cubic[0][axis], d1 = cubic[1][axis] - c0, d2 = cubic[2][axis] - c0, d3 = cubic[3][axis] - c0, s = 1 - t;
    return c0 + t * (3 * s * s * d1 + t * (3 * s * d2 + t * d3));
}

static void piece_polynomial(double cubic[4][3], double first, double last, double polynomial[3][3])
{
    for (int k = 0; k < 3; k++) {
        double start = cubic_at(cubic, k, first), end = cubic_at(cubic, k, last);
        double middle = cubic_at(cubic, k, 0.5 * (first + last));
        polynomial[0][k] = start;
        polynomial[1][k] = 4 * (middle - start) - (end - start);
        polynomial[2][k] = 2 * (end - start) - 4 * (middle - start);
    }
}

static bool add_span(path_parts *parts, const ew_path *path, size_t span, double core)
{
    double cubic[4][3], share = 1 / (double)path_span_count(path);
    path_span(path, span, cubic);
    bool is_cubic = path->kind == EW_PATH_BEZIER || path->kind == EW_PATH_CATMULL_ROM;
    size_t count = piece_count_of(cubic, is_cubic, core);
    if (!reserve(parts, 2 * (parts->piece_count + count))) return false;
    for (size_t i = 0; i < count; i++) {
        double first = (double)i / (double)count, last = (double)(i + 1) / (double)count;
        path_piece *piece = &parts->pieces[parts->piece_count++];
        *piece = (path_piece){
            .arc.domain = {0, 1},
            .path = path,
            .first_u = ((double)span + first) * share,
            .last_u = fmin(1, ((double)span + last) * share),
        };
        piece_polynomial(cubic, first, last, piece->arc.polynomial);
        if (path->kind == EW_PATH_POLYLINE)
            for (int k = 0; k < 3; k++)
                piece->arc.polynomial[2][k] = 0;
    }
    return true;
}

/* A joint at the start of each piece but an open path's first, with the weight there. Where a closed path meets itself, and its
 * weight may jump, that is the first. */
static void add_joints(path_parts *parts, const ew_path *path)
{
    for (size_t i = !path->is_closed; i < parts->piece_count; i++) {
        const path_piece *piece = &parts->pieces[i];
        path_joint *joint = &parts->joints[parts->joint_count++];
        *joint = (path_joint){.weight = reference_weight(path->weights, path->weight_count, piece->first_u)};
        vector_copy(piece->arc.polynomial[0], joint->point.position);
    }
}

bool path_parts_make(path_parts *parts, const ew_path *path, double core)
{
    parts->piece_count = parts->joint_count = 0;
    for (size_t span = 0; span < path_span_count(path); span++)
        if (!add_span(parts, path, span, core)) return false;
    add_joints(parts, path);
    return true;
}

void path_parts_free(path_parts *parts)
{
    free(parts->pieces);
    free(parts->joints);
    *parts = (path_parts){0};
}
