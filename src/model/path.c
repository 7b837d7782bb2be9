/* Paths: see path.h. */
#include "model/path.h"

#include "base/error.h"
#include "model/vector.h"
#include "model/weights.h"

/* How far the pieces may be from a cubic, in cores. */
#define CUBIC_TOLERANCE 3e-4
/* How far a straight piece may be from the curve that it replaces, in cores: the luminance at the core's edge changes by as
 * much over ln(reach / core). */
#define STRAIGHT_TOLERANCE 1e-3
/* The longest piece that is left out, in cores. */
#define POINT_TOLERANCE 1e-6

/* ---- Checks ---- */

static size_t span_count(const ew_path *path)
{
    size_t count = path->point_count;
    if (path->kind == EW_PATH_BEZIER) return (count - 1) / 3;
    if (path->is_closed) return count;
    return path->kind == EW_PATH_BSPLINE ? count - 2 : count - 1;
}

static ew_result check_point_count(const ew_path *path, const ew_source_name *name, ew_error *error)
{
    const char *needed = NULL;
    if (path->kind == EW_PATH_BEZIER && (path->point_count < 4 || path->point_count % 3 != 1))
        needed = "3 n + 1 for EW_PATH_BEZIER, with n >= 1";
    else if (path->kind == EW_PATH_BSPLINE && path->point_count < 3)
        needed = "3 or more for EW_PATH_BSPLINE";
    else if (path->is_closed && path->point_count < 3)
        needed = "3 or more if is_closed";
    else if (path->point_count < 2)
        needed = "2 or more";
    if (needed)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].points must be %s, not %zu", name->list, name->index, needed,
                       path->point_count);
    if (span_count(path) > EW_MAX_PATH_PIECES)
        return ew_fail(error, EW_ERROR_TOO_MANY_SOURCES,
                       "%s[%zu].points are too many: they make %zu pieces, and a path has at most %d", name->list, name->index,
                       span_count(path), EW_MAX_PATH_PIECES);
    return EW_OK;
}

/* The count is known to be right before any point is read. */
static ew_result check_points(const ew_path *path, const ew_source_name *name, ew_error *error)
{
    if (!path->points)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].points must not be NULL", name->list, name->index);
    ew_result result = check_point_count(path, name, error);
    for (size_t i = 0; i < path->point_count && result == EW_OK; ++i)
        if (!ew_all_finite(path->points[i], 3))
            result =
                ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].points[%zu] must be finite", name->list, name->index, i);
    return result;
}

ew_result ew_check_path(const ew_path *path, const ew_source_name *name, ew_error *error)
{
    if ((unsigned)path->kind > EW_PATH_CATMULL_ROM)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].kind must be an ew_path_kind", name->list, name->index);
    if (path->is_closed != 0 && path->is_closed != 1)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].is_closed must be 0 or 1", name->list, name->index);
    if (path->is_closed && path->kind == EW_PATH_BEZIER)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].is_closed must be 0 for EW_PATH_BEZIER", name->list,
                       name->index);
    ew_result result = check_points(path, name, error);
    if (result != EW_OK) return result;
    return ew_check_weights((ew_weight_list){path->weights, path->weight_count}, name, error);
}

/* ---- Spans between control points ---- */

static ew_quadratic polyline_span(const ew_path *path, size_t span)
{
    const double *start = path->points[span], *end = path->points[(span + 1) % path->point_count];
    const double chord[3] = {end[0] - start[0], end[1] - start[1], end[2] - start[2]};
    return ew_quadratic_from_chord(start, chord, (const double[3]){0, 0, 0});
}

/* The first and the last point of an open spline are ends; the others are control points between two joints. A closed one
 * begins at the joint before its first point. */
static ew_quadratic bspline_span(const ew_path *path, size_t span)
{
    size_t count = path->point_count, at = path->is_closed ? span : span + 1;
    const double *before = path->points[(at + count - 1) % count], *middle = path->points[at];
    const double *after = path->points[(at + 1) % count];
    bool starts_at_end = !path->is_closed && at == 1, ends_at_end = !path->is_closed && at == count - 2;
    double start[3], chord[3], bend[3];
    for (int i = 0; i < 3; ++i) {
        double to_middle = (middle[i] - before[i]) * (starts_at_end ? 1 : 0.5);
        double from_middle = (after[i] - middle[i]) * (ends_at_end ? 1 : 0.5);
        start[i] = starts_at_end ? before[i] : 0.5 * before[i] + 0.5 * middle[i];
        chord[i] = to_middle + from_middle;
        bend[i] = from_middle - to_middle;
    }
    return ew_quadratic_from_chord(start, chord, bend);
}

static ew_cubic bezier_span(const ew_path *path, size_t span)
{
    ew_cubic cubic;
    for (size_t k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i)
            cubic.points[k][i] = path->points[3 * span + k][i];
    return cubic;
}

/* Half of the way from the point before to the point after. With a mirrored neighbour that is the whole way to the other. */
static void catmull_rom_tangent(const ew_path *path, size_t at, double tangent[3])
{
    size_t count = path->point_count;
    bool is_first = !path->is_closed && at == 0, is_last = !path->is_closed && at == count - 1;
    const double *before = path->points[is_first ? at : (at + count - 1) % count];
    const double *after = path->points[is_last ? at : (at + 1) % count];
    for (int i = 0; i < 3; ++i)
        tangent[i] = (after[i] - before[i]) * (is_first || is_last ? 1 : 0.5);
}

static ew_cubic catmull_rom_span(const ew_path *path, size_t span)
{
    size_t next = (span + 1) % path->point_count;
    double tangents[2][3];
    catmull_rom_tangent(path, span, tangents[0]);
    catmull_rom_tangent(path, next, tangents[1]);
    ew_cubic cubic;
    for (int i = 0; i < 3; ++i) {
        cubic.points[0][i] = path->points[span][i];
        cubic.points[1][i] = path->points[span][i] + tangents[0][i] / 3;
        cubic.points[2][i] = path->points[next][i] - tangents[1][i] / 3;
        cubic.points[3][i] = path->points[next][i];
    }
    return cubic;
}

/* ---- Pieces ---- */

typedef struct piece_chain {
    const ew_path *path;
    double core;
    ew_path_piece *pieces; /* NULL to count only */
    size_t count;
} piece_chain;

/* Adds a piece for the part of a span from `start` to `end`. */
static void add_piece(piece_chain *chain, ew_quadratic curve, size_t span, double start, double end)
{
    if (ew_quadratic_is_point(&curve, POINT_TOLERANCE * chain->core)) return;
    double spans = (double)span_count(chain->path);
    if (chain->pieces)
        chain->pieces[chain->count] = (ew_path_piece){
            .curve = curve,
            .domain = {((double)span + start) / spans, ((double)span + end) / spans},
            .is_straight = ew_quadratic_is_straight(&curve, STRAIGHT_TOLERANCE * chain->core),
            .starts_at_joint = chain->count > 0 || chain->path->is_closed,
        };
    ++chain->count;
}

static void add_cubic(piece_chain *chain, ew_cubic cubic, size_t span)
{
    double parts = ew_cubic_part_count(&cubic, CUBIC_TOLERANCE * chain->core);
    if (!(parts <= EW_MAX_PATH_PIECES)) {
        chain->count = EW_MAX_PATH_PIECES + 1;
        return;
    }
    for (double part = 0; part < parts; ++part) {
        double start = part / parts, end = (part + 1) / parts;
        add_piece(chain, ew_cubic_part(&cubic, start, end), span, start, end);
    }
}

static void add_span(piece_chain *chain, size_t span)
{
    switch (chain->path->kind) {
    case EW_PATH_POLYLINE:
        add_piece(chain, polyline_span(chain->path, span), span, 0, 1);
        break;
    case EW_PATH_BSPLINE:
        add_piece(chain, bspline_span(chain->path, span), span, 0, 1);
        break;
    case EW_PATH_BEZIER:
        add_cubic(chain, bezier_span(chain->path, span), span);
        break;
    case EW_PATH_CATMULL_ROM:
        add_cubic(chain, catmull_rom_span(chain->path, span), span);
        break;
    }
}

static void add_point(piece_chain *chain)
{
    const double none[3] = {0, 0, 0};
    if (chain->pieces)
        chain->pieces[0] = (ew_path_piece){
            .curve = ew_quadratic_from_chord(chain->path->points[0], none, none),
            .domain = {0, 1},
            .is_straight = true,
        };
    chain->count = 1;
}

/* Stops soon after there are too many. */
static size_t add_path(const ew_path *path, double core, ew_path_piece *pieces)
{
    piece_chain chain = {path, core, pieces, 0};
    for (size_t span = 0; span < span_count(path) && chain.count <= EW_MAX_PATH_PIECES; ++span)
        add_span(&chain, span);
    if (chain.count == 0) add_point(&chain);
    return chain.count;
}

ew_result ew_count_path_pieces(const ew_path *path, double core, const ew_source_name *name, size_t *count, ew_error *error)
{
    size_t needed = add_path(path, core, NULL);
    if (needed > EW_MAX_PATH_PIECES)
        return ew_fail(error, EW_ERROR_TOO_MANY_SOURCES,
                       "%s[%zu].points bend too much for so small a core: a path has at most %d quadratic pieces", name->list,
                       name->index, EW_MAX_PATH_PIECES);
    *count = needed;
    return EW_OK;
}

void ew_make_path_pieces(const ew_path *path, double core, ew_path_piece *pieces)
{
    add_path(path, core, pieces);
}
