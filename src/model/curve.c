/* Curves: arcs of parabolas, with weights along them. */
#include "glsl_text.h"
#include "model/kinds.h"
#include "model/vector.h"
#include "model/weights.h"

#include "base/error.h"

EW_CHECK_KIND(curve, EW_MAX_CURVES);

/* A parabola's vertex farther than this from the arc, in lengths of the arc's parameter domain, is no longer taken as origin:
 * the arc turns by less than 7 degrees then, and coordinates from the vertex would lose digits. */
#define MAX_VERTEX_DISTANCE 4.0

static ew_weight_list weights_of(const void *source)
{
    const ew_curve *curve = source;
    return (ew_weight_list){curve->weights, curve->weight_count};
}

static ew_result check(const void *source, const ew_source_name *name, ew_error *error)
{
    const ew_curve *curve = source;
    if (!ew_all_finite(&curve->polynomial[0][0], 9))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].polynomial must be finite", name->list, name->index);
    if (!ew_all_finite(curve->domain, 2) || !(curve->domain[0] < curve->domain[1]) ||
        !isfinite(curve->domain[1] - curve->domain[0]))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].domain must be finite, its start less than its end",
                       name->list, name->index);
    return ew_check_weights(weights_of(curve), name, error);
}

/* Around the middle m of the domain: C(m + x) - C(m) = x C'(m) + x^2 C2. */
static ew_ball bound(const void *source)
{
    const ew_curve *curve = source;
    double middle = 0.5 * (curve->domain[0] + curve->domain[1]), half = 0.5 * (curve->domain[1] - curve->domain[0]);
    double slope[3], bend[3];
    ew_ball ball;
    for (int i = 0; i < 3; ++i) {
        double c0 = curve->polynomial[0][i], c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i];
        ball.center[i] = c0 + middle * (c1 + middle * c2);
        slope[i] = half * (c1 + 2 * middle * c2);
        bend[i] = half * half * c2;
    }
    ball.radius = sqrt(ew_dot(slope, slope)) + sqrt(ew_dot(bend, bend));
    return ball;
}

/* The arc C(u) = start + u tangent + u^2 bend with u in [0, 1], t = domain[0] + u (domain[1] - domain[0]), in ray space. */
typedef struct parabola_arc {
    double start[3], tangent[3], bend[3];
} parabola_arc;

static parabola_arc arc_in_ray_space(const ew_ray_space *space, const ew_curve *curve)
{
    double t0 = curve->domain[0], length = curve->domain[1] - curve->domain[0];
    double world_start[3], world_tangent[3], world_bend[3];
    for (int i = 0; i < 3; ++i) {
        double c0 = curve->polynomial[0][i], c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i];
        world_start[i] = c0 + t0 * (c1 + t0 * c2);
        world_tangent[i] = (c1 + 2 * t0 * c2) * length / space->length;
        world_bend[i] = c2 * length * length / space->length;
    }
    parabola_arc made;
    ew_ray_space_place(space, world_start, made.start);
    ew_ray_space_turn(space, world_tangent, made.tangent);
    ew_ray_space_turn(space, world_bend, made.bend);
    return made;
}

/* Where the arc's origin goes: to its vertex, or to its middle where the vertex is far away. */
static double choose_origin(const parabola_arc *arc, bool *at_vertex)
{
    const double middle = 0.5;
    double bend2 = ew_dot(arc->bend, arc->bend);
    *at_vertex = false;
    if (!(bend2 > 0)) return middle;
    double vertex = -ew_dot(arc->tangent, arc->bend) / (2 * bend2);
    *at_vertex = fabs(vertex - middle) <= 0.5 + MAX_VERTEX_DISTANCE;
    if (!*at_vertex) return middle;
    /* Two control points that coincide make an arc end at its vertex, up to rounding. */
    if (fabs(vertex) < 1e-9) return 0;
    return fabs(vertex - 1) < 1e-9 ? 1 : vertex;
}

/* Turns the arc into the frame of its plane: axis_y along the bend, axis_x along the rest of the tangent. A straight or folded
 * arc lies in many planes; any will do. */
static void pack_arc(const parabola_arc *arc, struct ew_curve_block *block)
{
    bool at_vertex;
    double tau = choose_origin(arc, &at_vertex);
    double origin[3], tangent[3], axis_x[3], axis_y[3], axis_z[3];
    for (int i = 0; i < 3; ++i) {
        origin[i] = arc->start[i] + tau * (arc->tangent[i] + tau * arc->bend[i]);
        tangent[i] = arc->tangent[i] + 2 * tau * arc->bend[i];
    }
    double unit_tangent[3] = {1, 0, 0};
    ew_normalize(tangent, unit_tangent);
    if (!ew_normalize(arc->bend, axis_y)) ew_perpendicular(unit_tangent, axis_y);
    double slope_y = at_vertex ? 0 : ew_dot(tangent, axis_y);
    double rest[3];
    for (int i = 0; i < 3; ++i)
        rest[i] = tangent[i] - ew_dot(tangent, axis_y) * axis_y[i];
    double slope_x = sqrt(ew_dot(rest, rest));
    /* Of a tangent along the bend only rounding errors are left, and they have no direction. */
    double length = sqrt(ew_dot(arc->tangent, arc->tangent)) + sqrt(ew_dot(arc->bend, arc->bend));
    if (slope_x <= 1e-12 * length || !ew_normalize(rest, axis_x)) {
        slope_x = 0;
        ew_perpendicular(axis_y, axis_x);
    }
    ew_cross(axis_x, axis_y, axis_z);
    block->origin = ew_pack(origin, 0);
    block->axis_x = ew_pack(axis_x, slope_x);
    block->axis_y = ew_pack(axis_y, slope_y);
    block->axis_z = ew_pack(axis_z, sqrt(ew_dot(arc->bend, arc->bend)));
    block->domain.x = (float)-tau;
    block->domain.y = (float)(1 - tau);
}

static ew_result pack(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error)
{
    struct ew_curve_block *packed = block;
    parabola_arc arc = arc_in_ray_space(space, source);
    ew_result result = ew_check_coordinates(name, arc.start, error);
    if (result == EW_OK) result = ew_check_coordinates(name, arc.tangent, error);
    if (result == EW_OK) result = ew_check_coordinates(name, arc.bend, error);
    if (result != EW_OK) return result;
    pack_arc(&arc, packed);
    packed->origin.w = (float)weights->mean;
    packed->domain.z = (float)weights->first_piece;
    packed->domain.w = (float)weights->piece_count;
    return EW_OK;
}

extern const ew_kind ew_curve_kind;
const ew_kind ew_curve_kind = {
    EW_KIND_NAMES(curve, CURVE, curves),
    .check = check,
    .bound = bound,
    .weights = weights_of,
    .pack = pack,
    .adaptive_files = {ew_glsl_arc_glsl, ew_glsl_passage_glsl, ew_glsl_cell_glsl, ew_glsl_stretch_glsl, ew_glsl_rest_glsl,
                       ew_glsl_knot_glsl, ew_glsl_rest_panels_glsl, ew_glsl_curve_glsl},
    .sampling_files = {ew_glsl_curve_distance_glsl},
};
