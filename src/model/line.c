/* Infinite lines. */
#include "glsl_text.h"
#include "model/kinds.h"
#include "model/vector.h"

EW_CHECK_KIND(line, EW_MAX_LINES);

static ew_result check(const void *source, const ew_source_name *name, ew_error *error)
{
    const ew_line *line = source;
    ew_result result = ew_check_vector(name, "position", line->position, error);
    return result == EW_OK ? ew_check_direction(name, "direction", line->direction, error) : result;
}

static ew_ball bound(const void *source)
{
    const ew_line *line = source;
    ew_ball ball = {.center = {line->position[0], line->position[1], line->position[2]}, .radius = HUGE_VAL};
    ew_normalize(line->direction, ball.axis);
    return ball;
}

static ew_hull hull(const void *source)
{
    const ew_line *line = source;
    ew_hull hull = {.corners = {{line->position[0], line->position[1], line->position[2]}}, .corner_count = 1};
    ew_normalize(line->direction, hull.direction);
    return hull;
}

/* The block's position is the point of the line that is nearest to the anchor: it has the smallest coordinates. */
static ew_result pack(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error)
{
    const ew_line *line = source;
    struct ew_line_block *packed = block;
    (void)weights;
    double position[3], direction[3], world_direction[3];
    ew_normalize(line->direction, world_direction);
    ew_ray_space_turn(space, world_direction, direction);
    ew_ray_space_place(space, line->position, position);
    double along = ew_dot(position, direction);
    for (int i = 0; i < 3; ++i)
        position[i] -= along * direction[i];
    packed->position = ew_pack(position, 0);
    packed->direction = ew_pack(direction, 0);
    return ew_check_coordinates(name, position, error);
}

extern const ew_kind ew_line_kind;
const ew_kind ew_line_kind = {
    EW_KIND_NAMES(line, LINE, lines),
    .check = check,
    .cost_in_points = 1,
    .list = EW_LIST_LINES,
    .bound = bound,
    .hull = hull,
    .pack = pack,
    .adaptive_files = {ew_glsl_line_glsl},
    .sampling_files = {ew_glsl_line_glsl},
    .irradiance_files = {ew_glsl_straight_emitter_glsl, ew_glsl_line_irradiance_glsl},
    .gloss_files = {ew_glsl_line_gloss_glsl},
};
