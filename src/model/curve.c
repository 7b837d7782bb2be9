/* Curves: arcs of parabolas, with weights along them. */
#include "glsl_text.h"
#include "model/arc.h"
#include "model/kinds.h"
#include "model/vector.h"
#include "model/weights.h"

#include "base/error.h"

EW_CHECK_KIND(curve, EW_MAX_CURVES);

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

static ew_hull hull(const void *source)
{
    const ew_curve *curve = source;
    return ew_hull_of_arc(curve->polynomial, curve->domain);
}

static ew_result pack(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error)
{
    struct ew_curve_block *packed = block;
    const ew_curve *curve = source;
    const ew_arc arc = ew_arc_in_ray_space(space, curve->polynomial, curve->domain);
    ew_result result = ew_check_arc(&arc, name, error);
    if (result != EW_OK) return result;
    const ew_arc_frame frame = ew_find_arc_frame(&arc);
    packed->origin = ew_pack(frame.origin, 0);
    packed->axis_x = ew_pack(frame.axis_x, frame.slope_x);
    packed->axis_y = ew_pack(frame.axis_y, frame.slope_y);
    packed->axis_z = ew_pack(frame.axis_z, frame.bend);
    packed->domain.x = (float)frame.first;
    packed->domain.y = (float)frame.last;
    packed->origin.w = (float)weights->mean;
    packed->domain.z = (float)weights->first_piece;
    packed->domain.w = (float)weights->piece_count;
    return EW_OK;
}

extern const ew_kind ew_curve_kind;
const ew_kind ew_curve_kind = {
    EW_KIND_NAMES(curve, CURVE, curves),
    .check = check,
    .cost_in_points = 8,
    .list = EW_LIST_CURVES,
    .part = EW_PART_CURVES,
    .bound = bound,
    .chord_file = ew_glsl_curve_chord_glsl,
    .hull = hull,
    .weights = weights_of,
    .pack = pack,
    .adaptive_files = {ew_glsl_arc_glsl, ew_glsl_passage_glsl, ew_glsl_cell_glsl, ew_glsl_stretch_glsl, ew_glsl_rest_glsl,
                       ew_glsl_knot_glsl, ew_glsl_rest_panels_glsl, ew_glsl_curve_glsl},
    .sampling_files = {ew_glsl_polynomial_curve_glsl, ew_glsl_curve_distance_glsl},
    .irradiance_files = {ew_glsl_polynomial_curve_glsl, ew_glsl_straight_emitter_glsl, ew_glsl_bent_emitter_glsl,
                         ew_glsl_curve_irradiance_glsl},
    .gloss_files = {ew_glsl_chords_glsl, ew_glsl_curve_gloss_glsl},
};
