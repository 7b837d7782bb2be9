/* Source lists: validate, bring to the camera in double precision, pack into uniform blocks. */
#include "model/scene.h"

#include "base/error.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* The ranges inside which no intermediate result of the shader overflows a float or vanishes in one; lengths in intervals.
 * They are far outside anything that could be seen. */
#define MAX_COORDINATE 1e6
#define MIN_EPSILON 1e-12
#define MAX_COEFFICIENT 1e12
#define MAX_COLOR 65504.0
#define MIN_BETA 1e-6
#define MAX_BETA 1e6
#define MAX_INTERVAL_RATIO 1e12
#define MAX_WINDOW_DEPTH 1e15

/* A parabola's vertex farther than this from the arc, in lengths of the arc's parameter domain, is no longer taken as origin:
 * the arc turns by less than 7 degrees then, and coordinates from the vertex would lose digits. */
#define MAX_VERTEX_DISTANCE 4.0

#define CHECK_SIZE(source, vectors, most)                                                                                      \
    _Static_assert(sizeof(struct ew_##source##_block) == (vectors) * sizeof(ew_vec4), #source " takes other units in GLSL");   \
    _Static_assert((most) == EW_MAX_SOURCE_UNITS / (vectors), #source " takes other units in the public header")
CHECK_SIZE(point, EW_POINT_SIZE, EW_MAX_POINTS);
CHECK_SIZE(line, EW_LINE_SIZE, EW_MAX_LINES);
CHECK_SIZE(torus, EW_TORUS_SIZE, EW_MAX_TORI);
CHECK_SIZE(curve, EW_CURVE_SIZE, EW_MAX_CURVES);
CHECK_SIZE(weight, EW_WEIGHT_SIZE, EW_MAX_SOURCE_UNITS);
#undef CHECK_SIZE
_Static_assert(EW_MAX_SOURCE_UNITS * sizeof(ew_vec4) + sizeof(struct ew_frame_block) <= 65536,
               "the uniform block is too large");

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Scales first: the square of a length in range can be out of range. Returns false for a vector without direction. */
static bool normalize(const double v[3], double unit[3])
{
    double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (largest == 0) return false;
    for (int i = 0; i < 3; ++i)
        unit[i] = v[i] / largest;
    double length = sqrt(dot(unit, unit));
    for (int i = 0; i < 3; ++i)
        unit[i] /= length;
    return true;
}

static bool all_finite(const double *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(values[i])) return false;
    return true;
}

/* ---- The scene ---- */

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

size_t ew_scene_capacity(size_t block_size)
{
    return smaller(EW_MAX_SOURCE_UNITS, (block_size - sizeof(struct ew_frame_block)) / sizeof(ew_vec4));
}

static ew_result check_vector(const char *list, size_t index, const char *field, const double v[3], ew_error *error)
{
    if (all_finite(v, 3)) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].%s must be finite", list, index, field);
}

static ew_result check_direction(const char *list, size_t index, const char *field, const double v[3], ew_error *error)
{
    double unit[3];
    ew_result result = check_vector(list, index, field, v, error);
    if (result != EW_OK || normalize(v, unit)) return result;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].%s must not be zero", list, index, field);
}

static ew_result check_energy(const char *list, size_t index, double coefficient, const double color[3], ew_error *error)
{
    if (!(isfinite(coefficient) && coefficient >= 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].coefficient must be finite and >= 0", list, index);
    for (int i = 0; i < 3; ++i)
        if (!(color[i] >= 0 && color[i] <= MAX_COLOR))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].color must be in [0, %g]", list, index, MAX_COLOR);
    return EW_OK;
}

static ew_result check_curve(size_t index, const ew_curve *curve, ew_error *error)
{
    if (!all_finite(&curve->polynomial[0][0], 9))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "curves[%zu].polynomial must be finite", index);
    if (!all_finite(curve->domain, 2) || !(curve->domain[0] < curve->domain[1]) ||
        !isfinite(curve->domain[1] - curve->domain[0]))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "curves[%zu].domain must be finite, its start less than its end",
                       index);
    if ((curve->weights == NULL) != (curve->weight_count == 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "curves[%zu].weights and weight_count must both be given, or be NULL and 0", index);
    if (curve->weight_count > EW_MAX_WEIGHTS)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "curves[%zu].weight_count must be at most %d", index, EW_MAX_WEIGHTS);
    for (size_t i = 0; i < curve->weight_count; ++i)
        if (!(curve->weights[i] >= 0 && curve->weights[i] <= MAX_COEFFICIENT))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "curves[%zu].weights[%zu] must be in [0, %g]", index, i,
                           MAX_COEFFICIENT);
    return EW_OK;
}

static ew_result check_list(const char *list, const void *sources, size_t count, ew_error *error)
{
    if (sources || count == 0) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s must not be NULL with a count of %zu", list, count);
}

static size_t weight_piece_count(size_t weight_count)
{
    if (weight_count == 0) return 0;
    return weight_count > 2 ? weight_count - 2 : 1;
}

/* Takes what `count` sources need from the units that are left, before any of the sources is looked at. */
static ew_result take_units(const char *list, size_t count, size_t size, size_t *left, size_t capacity, ew_error *error)
{
    if (count > *left / size)
        return ew_fail(error, EW_ERROR_TOO_MANY_SOURCES,
                       "%zu %s of %zu units each are too many: this context takes %zu units of sources, of which %zu are left",
                       count, list, size, capacity, *left);
    *left -= count * size;
    return EW_OK;
}

static ew_result validate_sources(const ew_sources_desc *sources, size_t capacity, ew_error *error)
{
    ew_result result;
    if (!sources) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "sources must not be NULL");
    if (!(isfinite(sources->epsilon) && sources->epsilon > 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "epsilon must be finite and > 0");
    if ((result = check_list("points", sources->points, sources->point_count, error))) return result;
    if ((result = check_list("lines", sources->lines, sources->line_count, error))) return result;
    if ((result = check_list("tori", sources->tori, sources->torus_count, error))) return result;
    if ((result = check_list("curves", sources->curves, sources->curve_count, error))) return result;
    size_t left = capacity;
    if ((result = take_units("points", sources->point_count, EW_POINT_SIZE, &left, capacity, error))) return result;
    if ((result = take_units("lines", sources->line_count, EW_LINE_SIZE, &left, capacity, error))) return result;
    if ((result = take_units("tori", sources->torus_count, EW_TORUS_SIZE, &left, capacity, error))) return result;
    if ((result = take_units("curves", sources->curve_count, EW_CURVE_SIZE, &left, capacity, error))) return result;

    for (size_t i = 0; i < sources->point_count; ++i) {
        const ew_point *point = &sources->points[i];
        if ((result = check_vector("points", i, "position", point->position, error))) return result;
        if ((result = check_energy("points", i, point->coefficient, point->color, error))) return result;
    }
    for (size_t i = 0; i < sources->line_count; ++i) {
        const ew_line *line = &sources->lines[i];
        if ((result = check_vector("lines", i, "position", line->position, error))) return result;
        if ((result = check_direction("lines", i, "direction", line->direction, error))) return result;
        if ((result = check_energy("lines", i, line->coefficient, line->color, error))) return result;
    }
    for (size_t i = 0; i < sources->torus_count; ++i) {
        const ew_torus *torus = &sources->tori[i];
        if ((result = check_vector("tori", i, "center", torus->center, error))) return result;
        if ((result = check_direction("tori", i, "axis", torus->axis, error))) return result;
        if (!(isfinite(torus->radius) && torus->radius >= 0))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "tori[%zu].radius must be finite and >= 0", i);
        if ((result = check_energy("tori", i, torus->coefficient, torus->color, error))) return result;
    }
    size_t weight_pieces = 0;
    for (size_t i = 0; i < sources->curve_count; ++i) {
        const ew_curve *curve = &sources->curves[i];
        if ((result = check_curve(i, curve, error))) return result;
        if ((result = check_energy("curves", i, curve->coefficient, curve->color, error))) return result;
        weight_pieces += weight_piece_count(curve->weight_count);
    }
    return take_units("pieces of weights", weight_pieces, EW_WEIGHT_SIZE, &left, capacity, error);
}

/* The pieces of S(t), equation (15), as polynomials of the place f in [0, 1] along each: the quadratic B-spline with the knots
 * of (16), from its value and slope at the piece's start and its value at the end. */
static void make_weight_pieces(const double *weights, size_t count, struct ew_weight_block *pieces)
{
    if (count < 3) {
        double slope = count == 2 ? weights[1] - weights[0] : 0;
        pieces[0].polynomial = (ew_vec4){(float)weights[0], (float)slope, 0, 0};
        return;
    }
    for (size_t i = 0; i < count - 2; ++i) {
        /* The distances between knots i + 1, ..., i + 4 in units of the piece's own length: 1, but 0 between the repeated ones
         * at either end. */
        double before = i == 0 ? 0 : 1;
        double after = i == count - 3 ? 0 : 1;
        double start = (weights[i] + weights[i + 1] * before) / (1 + before);
        double slope = 2 * (weights[i + 1] - weights[i]) / (1 + before);
        double end = (weights[i + 1] * after + weights[i + 2]) / (1 + after);
        pieces[i].polynomial = (ew_vec4){(float)start, (float)slope, (float)(end - start - slope), 0};
    }
}

static double mean(const double *values, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; ++i)
        sum += values[i];
    return sum / (double)count;
}

/* Hands out the next `size` bytes of an allocation, or only counts them while there is none yet. */
static void *carve(char *memory, size_t *used, size_t size)
{
    void *part = memory ? memory + *used : NULL;
    *used += size;
    return part;
}

static void *copy(void *target, const void *source, size_t size)
{
    if (target && size > 0) memcpy(target, source, size);
    return target;
}

/* Lays the scene's arrays out in `memory` and copies the sources there; with NULL, only returns how much is needed. */
static size_t lay_out(const ew_sources_desc *sources, char *memory, ew_scene *scene)
{
    size_t used = 0;
    size_t points_size = sources->point_count * sizeof(ew_point);
    size_t lines_size = sources->line_count * sizeof(ew_line);
    size_t tori_size = sources->torus_count * sizeof(ew_torus);
    size_t curves_size = sources->curve_count * sizeof(ew_curve);
    scene->sources = *sources;
    scene->sources.points = copy(carve(memory, &used, points_size), sources->points, points_size);
    scene->sources.lines = copy(carve(memory, &used, lines_size), sources->lines, lines_size);
    scene->sources.tori = copy(carve(memory, &used, tori_size), sources->tori, tori_size);
    scene->sources.curves = copy(carve(memory, &used, curves_size), sources->curves, curves_size);
    size_t data_start = used;
    scene->points = carve(memory, &used, sources->point_count * sizeof(struct ew_point_block));
    scene->lines = carve(memory, &used, sources->line_count * sizeof(struct ew_line_block));
    scene->tori = carve(memory, &used, sources->torus_count * sizeof(struct ew_torus_block));
    scene->curves = carve(memory, &used, sources->curve_count * sizeof(struct ew_curve_block));
    scene->weight_piece_count = 0;
    for (size_t i = 0; i < sources->curve_count; ++i)
        scene->weight_piece_count += weight_piece_count(sources->curves[i].weight_count);
    scene->weight_pieces = carve(memory, &used, scene->weight_piece_count * sizeof(struct ew_weight_block));
    scene->source_data = scene->points;
    scene->source_data_size = used - data_start;
    return used;
}

ew_result ew_scene_set(ew_scene *scene, const ew_sources_desc *sources, size_t capacity, const ew_allocator *allocator,
                       ew_error *error)
{
    ew_result result = validate_sources(sources, capacity, error);
    if (result != EW_OK) return result;

    ew_scene made = {.memory = scene->memory, .memory_size = scene->memory_size};
    size_t size = lay_out(sources, NULL, &made);
    if (size > made.memory_size) {
        made.memory = allocator->allocate(allocator->user, size);
        if (!made.memory) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for %zu bytes of sources", size);
        made.memory_size = size;
        ew_scene_destroy(scene, allocator);
    }
    lay_out(sources, made.memory, &made);
    struct ew_weight_block *pieces = made.weight_pieces;
    for (size_t i = 0; i < sources->curve_count; ++i) {
        size_t count = sources->curves[i].weight_count;
        if (count > 0) make_weight_pieces(sources->curves[i].weights, count, pieces);
        made.curves[i].color.w = count > 0 ? (float)mean(sources->curves[i].weights, count) : 1;
        pieces += weight_piece_count(count);
    }
    *scene = made;
    return EW_OK;
}

ew_mix ew_scene_mix(const ew_scene *scene)
{
    const ew_sources_desc *sources = &scene->sources;
    return (ew_mix){sources->point_count, sources->line_count, sources->torus_count, sources->curve_count,
                    scene->weight_piece_count > 0};
}

void ew_scene_destroy(ew_scene *scene, const ew_allocator *allocator)
{
    if (scene->memory) allocator->deallocate(allocator->user, scene->memory);
    *scene = (ew_scene){0};
}

/* ---- The frame ---- */

/* A column-major matrix's element. */
static double element(const double matrix[16], int row, int column)
{
    return matrix[4 * column + row];
}

static bool is_rigid(const double view[16])
{
    /* Loose enough for a host that keeps its matrices in floats. */
    const double tolerance = 1e-4;
    for (int i = 0; i < 3; ++i) {
        if (element(view, 3, i) != 0) return false;
        for (int j = 0; j <= i; ++j)
            if (!(fabs(dot(&view[4 * i], &view[4 * j]) - (i == j)) <= tolerance)) return false;
    }
    return element(view, 3, 3) == 1;
}

static bool is_parallel(const double projection[16])
{
    return element(projection, 3, 2) == 0;
}

static ew_result validate_projection(const ew_frame_desc *frame, ew_error *error)
{
    const double *p = frame->projection;
    double w = is_parallel(p) ? element(p, 3, 3) : -element(p, 3, 2);
    bool other_w = element(p, 3, 0) != 0 || element(p, 3, 1) != 0 || (!is_parallel(p) && element(p, 3, 3) != 0);
    if (!all_finite(p, 16) || other_w || !(w > 0))
        return ew_fail(
            error, EW_ERROR_INVALID_ARGUMENT,
            "projection must be finite, its last row (0, 0, -w, 0) for perspective or (0, 0, 0, w) for parallel, w > 0");
    if (element(p, 0, 0) * element(p, 1, 1) - element(p, 0, 1) * element(p, 1, 0) == 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "projection must not flatten x and y");
    if (!is_parallel(p) && !(frame->interval_start > 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "interval_start must be > 0 for a perspective projection");
    if (!is_parallel(p) && !(frame->interval_end <= MAX_INTERVAL_RATIO * frame->interval_start))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "interval_end must be at most %g times interval_start for a perspective projection", MAX_INTERVAL_RATIO);
    return EW_OK;
}

static bool in_enum(int value, int last)
{
    return value >= 0 && value <= last;
}

ew_result ew_validate_frame(const ew_frame_desc *frame, ew_error *error)
{
    if (!frame) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "frame must not be NULL");
    if (!all_finite(frame->view, 16) || !is_rigid(frame->view))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "view must be finite, a rotation and a translation");
    if (!isfinite(frame->interval_start) || !isfinite(frame->interval_end) || !(frame->interval_start < frame->interval_end) ||
        !isfinite(frame->interval_end - frame->interval_start))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "interval_start must be less than interval_end, both finite");
    ew_result result = validate_projection(frame, error);
    if (result != EW_OK) return result;
    if (!(frame->decay_alpha >= 0 && frame->decay_alpha <= MAX_COEFFICIENT))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "decay_alpha must be in [0, %g]", MAX_COEFFICIENT);
    if (!(frame->decay_beta >= MIN_BETA && frame->decay_beta <= MAX_BETA))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "decay_beta must be in [%g, %g]", MIN_BETA, MAX_BETA);
    if (!in_enum((int)frame->clip_depth, EW_CLIP_DEPTH_ZERO_TO_ONE))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "clip_depth must be one of ew_clip_depth");
    if (!in_enum((int)frame->integrator, EW_INTEGRATOR_SIMPSON))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "integrator must be one of ew_integrator");
    if (!in_enum((int)frame->quality, EW_QUALITY_ERROR_1E_4))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "quality must be one of ew_quality");
    if (!in_enum((int)frame->output, EW_OUTPUT_EVALUATIONS))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "output must be one of ew_output");
    if (frame->integrator == EW_INTEGRATOR_SIMPSON && (frame->simpson_divisions < 2 || frame->simpson_divisions % 2 != 0 ||
                                                       frame->simpson_divisions > EW_MAX_SIMPSON_DIVISIONS))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "simpson_divisions must be even, from 2 to %d",
                       EW_MAX_SIMPSON_DIVISIONS);
    if (frame->viewport_width <= 0 || frame->viewport_height <= 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "viewport_width and viewport_height must be > 0");
    if (!in_enum((int)frame->encoding, EW_ENCODING_FLOAT))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "encoding must be one of ew_encoding");
    if (!in_enum((int)frame->depth_source, EW_DEPTH_FRAMEBUFFER))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_source must be one of ew_depth_source");
    if (!in_enum(frame->dither, 1)) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "dither must be 0 or 1");
    if (!in_enum(frame->skip_restore, 1)) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "skip_restore must be 0 or 1");
    return EW_OK;
}

/* ---- Packing ---- */

/* World space to ray space (see glsl/layout.glsl). */
typedef struct ray_space {
    const double *view;
    double start;  /* view depth of the anchor */
    double length; /* of the interval, world units */
} ray_space;

static void to_ray_space(const ray_space *space, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        double sum = element(space->view, row, 3);
        for (int column = 0; column < 3; ++column)
            sum += element(space->view, row, column) * world[column];
        if (row == 2) sum += space->start;
        out[row] = sum / space->length;
    }
}

static void rotate(const ray_space *space, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        out[row] = 0;
        for (int column = 0; column < 3; ++column)
            out[row] += element(space->view, row, column) * world[column];
    }
}

static ew_vec4 pack(const double v[3], double w)
{
    return (ew_vec4){(float)v[0], (float)v[1], (float)v[2], (float)w};
}

static ew_result check_coordinates(const char *list, size_t index, const double v[3], ew_error *error)
{
    for (int i = 0; i < 3; ++i)
        if (!(fabs(v[i]) <= MAX_COORDINATE))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                           "%s[%zu] is more than %g times the interval's length away from the camera or as large", list, index,
                           MAX_COORDINATE);
    return EW_OK;
}

/* d ds = (length d') (ds), so that a coefficient over the interval's length makes B what it is in world units. */
static ew_result scale_coefficient(const char *list, size_t index, const ray_space *space, const ew_frame_desc *frame,
                                   double coefficient, double *scaled, ew_error *error)
{
    *scaled = coefficient * frame->decay_alpha / space->length;
    if (*scaled <= MAX_COEFFICIENT) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                   "%s[%zu].coefficient times decay_alpha over the interval's length must be at most %g", list, index,
                   MAX_COEFFICIENT);
}

static void pack_line(const ray_space *space, const ew_line *line, double position[3], double direction[3])
{
    double world_direction[3];
    normalize(line->direction, world_direction);
    rotate(space, world_direction, direction);
    to_ray_space(space, line->position, position);
    double along = dot(position, direction);
    for (int i = 0; i < 3; ++i)
        position[i] -= along * direction[i];
}

/* A unit vector across `v`, along the coordinate axis that is most so. */
static void perpendicular(const double v[3], double unit[3])
{
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (fabs(v[i]) < fabs(v[least])) least = i;
    double across[3];
    for (int i = 0; i < 3; ++i)
        across[i] = (i == least ? 1 : 0) - v[least] * v[i];
    normalize(across, unit);
}

/* The arc over u in [0, 1], t = domain[0] + u (domain[1] - domain[0]), in ray space. */
static void arc_in_ray_space(const ray_space *space, const ew_curve *curve, double start[3], double tangent[3], double bend[3])
{
    double t0 = curve->domain[0], length = curve->domain[1] - curve->domain[0];
    double world_start[3], world_tangent[3], world_bend[3];
    for (int i = 0; i < 3; ++i) {
        double c0 = curve->polynomial[0][i], c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i];
        world_start[i] = c0 + t0 * (c1 + t0 * c2);
        world_tangent[i] = (c1 + 2 * t0 * c2) * length / space->length;
        world_bend[i] = c2 * length * length / space->length;
    }
    to_ray_space(space, world_start, start);
    rotate(space, world_tangent, tangent);
    rotate(space, world_bend, bend);
}

/* Moves the arc's origin to its vertex or middle, and turns it into the frame of its plane: axis_y along the bend, axis_x along
 * the rest of the tangent. A straight or folded arc lies in many planes; any will do. */
static void pack_arc(const double start[3], const double start_tangent[3], const double bend[3], struct ew_curve_block *block)
{
    double origin[3], tangent[3], axis_x[3], axis_y[3], axis_z[3];
    double middle = 0.5, vertex = 0.5;
    bool at_vertex = false;
    if (dot(bend, bend) > 0) {
        vertex = -dot(start_tangent, bend) / (2 * dot(bend, bend));
        at_vertex = fabs(vertex - middle) <= 0.5 + MAX_VERTEX_DISTANCE;
        /* Two control points that coincide make an arc end at its vertex, up to rounding. */
        if (fabs(vertex) < 1e-9) vertex = 0;
        if (fabs(vertex - 1) < 1e-9) vertex = 1;
    }
    double tau = at_vertex ? vertex : middle;
    for (int i = 0; i < 3; ++i) {
        origin[i] = start[i] + tau * (start_tangent[i] + tau * bend[i]);
        tangent[i] = start_tangent[i] + 2 * tau * bend[i];
    }
    double unit_tangent[3] = {1, 0, 0};
    normalize(tangent, unit_tangent);
    if (!normalize(bend, axis_y)) perpendicular(unit_tangent, axis_y);
    double slope_y = at_vertex ? 0 : dot(tangent, axis_y);
    double rest[3];
    for (int i = 0; i < 3; ++i)
        rest[i] = tangent[i] - dot(tangent, axis_y) * axis_y[i];
    double slope_x = sqrt(dot(rest, rest));
    /* Of a tangent along the bend only rounding errors are left, and they have no direction. */
    double length = sqrt(dot(start_tangent, start_tangent)) + sqrt(dot(bend, bend));
    if (slope_x <= 1e-12 * length || !normalize(rest, axis_x)) {
        slope_x = 0;
        perpendicular(axis_y, axis_x);
    }
    for (int i = 0; i < 3; ++i)
        axis_z[i] = axis_x[(i + 1) % 3] * axis_y[(i + 2) % 3] - axis_x[(i + 2) % 3] * axis_y[(i + 1) % 3];
    block->origin = pack(origin, 0);
    block->axis_x = pack(axis_x, slope_x);
    block->axis_y = pack(axis_y, slope_y);
    block->axis_z = pack(axis_z, sqrt(dot(bend, bend)));
    block->domain.x = (float)-tau;
    block->domain.y = (float)(1 - tau);
}

static ew_result pack_sources(ew_scene *scene, const ew_frame_desc *frame, const ray_space *space, ew_error *error)
{
    const ew_sources_desc *sources = &scene->sources;
    ew_result result;
    double coefficient, position[3], direction[3];
    for (size_t i = 0; i < sources->point_count; ++i) {
        const ew_point *point = &sources->points[i];
        to_ray_space(space, point->position, position);
        if ((result = check_coordinates("points", i, position, error))) return result;
        if ((result = scale_coefficient("points", i, space, frame, point->coefficient, &coefficient, error))) return result;
        scene->points[i] = (struct ew_point_block){pack(position, coefficient), pack(point->color, 0)};
    }
    for (size_t i = 0; i < sources->line_count; ++i) {
        const ew_line *line = &sources->lines[i];
        pack_line(space, line, position, direction);
        if ((result = check_coordinates("lines", i, position, error))) return result;
        if ((result = scale_coefficient("lines", i, space, frame, line->coefficient, &coefficient, error))) return result;
        scene->lines[i] = (struct ew_line_block){pack(position, coefficient), pack(direction, 0), pack(line->color, 0)};
    }
    for (size_t i = 0; i < sources->torus_count; ++i) {
        const ew_torus *torus = &sources->tori[i];
        double axis[3], radius = torus->radius / space->length;
        to_ray_space(space, torus->center, position);
        normalize(torus->axis, axis);
        rotate(space, axis, direction);
        if ((result = check_coordinates("tori", i, position, error))) return result;
        if ((result = check_coordinates("tori", i, (double[]){radius, 0, 0}, error))) return result;
        if ((result = scale_coefficient("tori", i, space, frame, torus->coefficient, &coefficient, error))) return result;
        scene->tori[i] = (struct ew_torus_block){pack(position, coefficient), pack(direction, radius), pack(torus->color, 0)};
    }
    size_t first_piece = 0;
    for (size_t i = 0; i < sources->curve_count; ++i) {
        const ew_curve *curve = &sources->curves[i];
        struct ew_curve_block *block = &scene->curves[i];
        double start[3], tangent[3], bend[3];
        size_t pieces = weight_piece_count(curve->weight_count);
        arc_in_ray_space(space, curve, start, tangent, bend);
        if ((result = check_coordinates("curves", i, start, error))) return result;
        if ((result = check_coordinates("curves", i, tangent, error))) return result;
        if ((result = check_coordinates("curves", i, bend, error))) return result;
        if ((result = scale_coefficient("curves", i, space, frame, curve->coefficient, &coefficient, error))) return result;
        pack_arc(start, tangent, bend, block);
        block->origin.w = (float)coefficient;
        block->color = pack(curve->color, (double)block->color.w);
        block->domain.z = (float)first_piece;
        block->domain.w = (float)pieces;
        first_piece += pieces;
    }
    return EW_OK;
}

/* Where the ray through NDC (x, y) is at view depth `depth`, in view space. */
static void ray_at(const double projection[16], double x, double y, double depth, double out[2])
{
    double w = is_parallel(projection) ? element(projection, 3, 3) : -element(projection, 3, 2) * depth;
    double right[2], ndc[2] = {x, y};
    for (int row = 0; row < 2; ++row)
        right[row] = ndc[row] * w + element(projection, row, 2) * depth - element(projection, row, 3);
    double a = element(projection, 0, 0), b = element(projection, 0, 1);
    double c = element(projection, 1, 0), d = element(projection, 1, 1);
    double determinant = a * d - b * c;
    out[0] = (d * right[0] - b * right[1]) / determinant;
    out[1] = (a * right[1] - c * right[0]) / determinant;
}

/* Window depth at view depth `depth` on the ray through NDC (x, y). */
static double window_depth_at(const ew_frame_desc *frame, double x, double y, double depth)
{
    const double *p = frame->projection;
    double position[2];
    ray_at(p, x, y, depth, position);
    double w = is_parallel(p) ? element(p, 3, 3) : -element(p, 3, 2) * depth;
    double ndc_depth =
        (element(p, 2, 0) * position[0] + element(p, 2, 1) * position[1] - element(p, 2, 2) * depth + element(p, 2, 3)) / w;
    return frame->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? ndc_depth : 0.5 * ndc_depth + 0.5;
}

/* Rays and their window depths change linearly over the picture and between the interval's ends, so that its corners bound them
 * all. */
static ew_result check_rays(const ew_frame_desc *frame, double length, ew_error *error)
{
    for (int corner = 0; corner < 8; ++corner) {
        double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, position[2];
        double depth = corner & 4 ? frame->interval_end : frame->interval_start;
        ray_at(frame->projection, x, y, depth, position);
        if (!(fabs(position[0]) <= MAX_COORDINATE * length && fabs(position[1]) <= MAX_COORDINATE * length))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "projection must show no more than %g times the interval's length",
                           MAX_COORDINATE);
        if (!(fabs(window_depth_at(frame, x, y, depth)) <= MAX_WINDOW_DEPTH))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                           "projection must give depths of at most %g at interval_start and interval_end", MAX_WINDOW_DEPTH);
    }
    return EW_OK;
}

static ew_vec4 pack_window_depth(const ew_frame_desc *frame, double depth)
{
    double center = window_depth_at(frame, 0, 0, depth);
    double right = window_depth_at(frame, 2.0 / frame->viewport_width, 0, depth) - center;
    double up = window_depth_at(frame, 0, 2.0 / frame->viewport_height, depth) - center;
    float rounded = (float)center;
    return (ew_vec4){rounded, (float)(center - (double)rounded), (float)right, (float)up};
}

static void pack_rays(const ew_frame_desc *frame, const ray_space *space, struct ew_frame_block *block)
{
    const double *p = frame->projection;
    double ndc[3][2] = {{0, 0}, {2.0 / frame->viewport_width, 0}, {0, 2.0 / frame->viewport_height}};
    double ray[3][4];
    for (int i = 0; i < 3; ++i) {
        double start[2], end[2];
        ray_at(p, ndc[i][0], ndc[i][1], frame->interval_start, start);
        ray_at(p, ndc[i][0], ndc[i][1], frame->interval_end, end);
        for (int j = 0; j < 2; ++j) {
            ray[i][j] = start[j] / space->length;
            ray[i][2 + j] = (end[j] - start[j]) / space->length;
        }
    }
    block->pixel_center = (ew_vec4){(float)(frame->viewport_x + 0.5 * frame->viewport_width),
                                    (float)(frame->viewport_y + 0.5 * frame->viewport_height), 0, 0};
    ew_vec4 *columns[3] = {&block->ray_center, &block->ray_right, &block->ray_up};
    for (int i = 0; i < 3; ++i) {
        double origin[4] = {0};
        if (i > 0) memcpy(origin, ray[0], sizeof origin);
        *columns[i] = (ew_vec4){(float)(ray[i][0] - origin[0]), (float)(ray[i][1] - origin[1]), (float)(ray[i][2] - origin[2]),
                                (float)(ray[i][3] - origin[3])};
    }

    block->depth_start = pack_window_depth(frame, frame->interval_start);
    block->depth_end = pack_window_depth(frame, frame->interval_end);
    double w_start = is_parallel(p) ? 1 : frame->interval_start / frame->interval_end;
    double sign =
        window_depth_at(frame, 0, 0, frame->interval_start) < window_depth_at(frame, 0, 0, frame->interval_end) ? 1 : -1;
    block->depth_scale = (ew_vec4){(float)(sign * w_start), (float)sign, 0, 0};
}

/* The rows that bring what is relative to the eye to ray space, for shaders of the host's. */
static void pack_ray_space(const ray_space *space, struct ew_frame_block *block)
{
    ew_vec4 *const rows[3] = {&block->ray_space_x, &block->ray_space_y, &block->ray_space_z};
    for (int row = 0; row < 3; ++row) {
        double scaled[3];
        for (int column = 0; column < 3; ++column)
            scaled[column] = element(space->view, row, column) / space->length;
        *rows[row] = pack(scaled, row == 2 ? space->start / space->length : 0);
    }
}

/* How much the four values of a panel may bend, relative to the integral, for the whole to keep the quality's error: measured,
 * not derived (docs/method.md). */
static double bend_tolerance(ew_quality quality)
{
    static const double tolerances[] = {
        [EW_QUALITY_ERROR_1E_2] = 1e-2, [EW_QUALITY_ERROR_1E_3] = 1e-3, [EW_QUALITY_ERROR_1E_4] = 1e-4};
    return tolerances[quality];
}

ew_result ew_scene_pack(ew_scene *scene, const ew_frame_desc *frame, struct ew_frame_block *block, ew_error *error)
{
    ray_space space = {frame->view, frame->interval_start, frame->interval_end - frame->interval_start};
    double epsilon = scene->sources.epsilon / space.length;
    if (!(epsilon >= MIN_EPSILON && epsilon <= MAX_COORDINATE))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "epsilon over the interval's length must be in [%g, %g]", MIN_EPSILON,
                       MAX_COORDINATE);
    ew_result result = check_rays(frame, space.length, error);
    if (result == EW_OK) result = pack_sources(scene, frame, &space, error);
    if (result != EW_OK) return result;

    *block = (struct ew_frame_block){0};
    pack_rays(frame, &space, block);
    pack_ray_space(&space, block);
    block->decay = (ew_vec4){(float)frame->decay_beta, (float)epsilon, (float)bend_tolerance(frame->quality), 0};
    block->source_count = (ew_ivec4){(int)scene->sources.point_count, (int)scene->sources.line_count,
                                     (int)scene->sources.torus_count, (int)scene->sources.curve_count};
    block->simpson.x = frame->simpson_divisions;
    return EW_OK;
}
