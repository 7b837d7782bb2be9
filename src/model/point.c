/* Points. */
#include "glsl_text.h"
#include "model/kinds.h"

EW_CHECK_KIND(point, EW_MAX_POINTS);

static ew_result check(const void *source, const ew_source_name *name, ew_error *error)
{
    const ew_point *point = source;
    return ew_check_vector(name, "position", point->position, error);
}

static ew_ball bound(const void *source)
{
    const ew_point *point = source;
    return (ew_ball){.center = {point->position[0], point->position[1], point->position[2]}};
}

static ew_hull hull(const void *source)
{
    const ew_point *point = source;
    return (ew_hull){.corners = {{point->position[0], point->position[1], point->position[2]}}, .corner_count = 1};
}

static ew_result pack(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error)
{
    const ew_point *point = source;
    struct ew_point_block *packed = block;
    (void)weights;
    double position[3];
    ew_ray_space_place(space, point->position, position);
    packed->position = ew_pack(position, 0);
    return ew_check_coordinates(name, position, error);
}

extern const ew_kind ew_point_kind;
const ew_kind ew_point_kind = {
    EW_KIND_NAMES(point, POINT, points),
    .check = check,
    .cost_in_points = 1,
    .list = EW_LIST_POINTS,
    .bound = bound,
    .hull = hull,
    .pack = pack,
    .adaptive_files = {ew_glsl_point_glsl},
    .sampling_files = {ew_glsl_point_glsl},
    .irradiance_files = {ew_glsl_point_irradiance_glsl},
    .gloss_files = {ew_glsl_point_gloss_glsl},
};
