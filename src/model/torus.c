/* Tori: circles of a radius. */
#include "glsl_text.h"
#include "model/kinds.h"
#include "model/vector.h"

#include "base/error.h"

EW_CHECK_KIND(torus, EW_MAX_TORI);

static ew_result check(const void *source, const ew_source_name *name, ew_error *error)
{
    const ew_torus *torus = source;
    ew_result result = ew_check_vector(name, "center", torus->center, error);
    if (result == EW_OK) result = ew_check_direction(name, "axis", torus->axis, error);
    if (result != EW_OK) return result;
    if (isfinite(torus->radius) && torus->radius >= 0) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].radius must be finite and >= 0", name->list, name->index);
}

static ew_ball bound(const void *source)
{
    const ew_torus *torus = source;
    return (ew_ball){.center = {torus->center[0], torus->center[1], torus->center[2]}, .radius = torus->radius};
}

/* The regular polygon with the circle in it. */
static ew_hull hull(const void *source)
{
    const ew_torus *torus = source;
    const double step = acos(-1) / EW_MAX_HULL_CORNERS, radius = torus->radius / cos(step);
    double axis[3], right[3], up[3];
    ew_normalize(torus->axis, axis);
    ew_perpendicular(axis, right);
    ew_cross(axis, right, up);
    ew_hull hull = {.corner_count = EW_MAX_HULL_CORNERS};
    for (int corner = 0; corner < EW_MAX_HULL_CORNERS; ++corner)
        for (int i = 0; i < 3; ++i)
            hull.corners[corner][i] =
                torus->center[i] + radius * (cos(2 * corner * step) * right[i] + sin(2 * corner * step) * up[i]);
    return hull;
}

static ew_result pack(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error)
{
    const ew_torus *torus = source;
    struct ew_torus_block *packed = block;
    (void)weights;
    double center[3], axis[3], world_axis[3], radius = torus->radius / space->length;
    ew_ray_space_place(space, torus->center, center);
    ew_normalize(torus->axis, world_axis);
    ew_ray_space_turn(space, world_axis, axis);
    packed->center = ew_pack(center, 0);
    packed->axis = ew_pack(axis, radius);
    ew_result result = ew_check_coordinates(name, center, error);
    return result == EW_OK ? ew_check_coordinates(name, (double[]){radius, 0, 0}, error) : result;
}

extern const ew_kind ew_torus_kind;
const ew_kind ew_torus_kind = {
    EW_KIND_NAMES(torus, TORUS, tori),
    .check = check,
    .cost_in_points = 4,
    .list = EW_LIST_TORI,
    .part = EW_PART_TORI,
    .bound = bound,
    .chord_file = ew_glsl_torus_chord_glsl,
    .hull = hull,
    .pack = pack,
    .adaptive_files = {ew_glsl_torus_side_glsl, ew_glsl_torus_core_glsl, ew_glsl_torus_part_glsl, ew_glsl_product_rule_glsl,
                       ew_glsl_torus_panel_glsl, ew_glsl_torus_glsl},
    .sampling_files = {ew_glsl_torus_distance_glsl},
    .irradiance_files = {ew_glsl_straight_emitter_glsl, ew_glsl_torus_irradiance_glsl},
    .gloss_files = {ew_glsl_torus_gloss_glsl},
};
