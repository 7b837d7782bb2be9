/* Paths: the row of the kind. path.c makes their pieces. */
#include "glsl_text.h"
#include "model/arc.h"
#include "model/path.h"
#include "model/vector.h"

EW_CHECK_KIND(path, EW_MAX_PATHS);

static ew_weight_list weights_of(const void *source)
{
    const ew_path *path = source;
    return (ew_weight_list){path->weights, path->weight_count};
}

static ew_result check(const void *source, const ew_source_name *name, ew_error *error)
{
    return ew_check_path(source, name, error);
}

/* Around the points' mean. A Catmull-Rom spline leaves the ball of its points: its control points are up to two thirds of the
 * radius away from them. */
static ew_ball bound(const void *source)
{
    const ew_path *path = source;
    ew_ball ball = {.radius = 0};
    for (size_t i = 0; i < path->point_count; ++i)
        for (int k = 0; k < 3; ++k)
            ball.center[k] += path->points[i][k] / (double)path->point_count;
    for (size_t i = 0; i < path->point_count; ++i) {
        double away[3];
        for (int k = 0; k < 3; ++k)
            away[k] = path->points[i][k] - ball.center[k];
        ball.radius = fmax(ball.radius, sqrt(ew_dot(away, away)));
    }
    if (path->kind == EW_PATH_CATMULL_ROM) ball.radius *= 5.0 / 3.0;
    return ball;
}

static ew_result pack(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error)
{
    const ew_path *path = source;
    struct ew_path_block *packed = block;
    (void)name;
    (void)space;
    (void)error;
    packed->pieces.w = (float)path->is_closed;
    packed->weights = (ew_vec4){(float)weights->first_piece, (float)weights->piece_count, (float)weights->mean, 0};
    return EW_OK;
}

/* ---- Pieces ---- */

static ew_result count(const void *source, double core, const ew_source_name *name, size_t *pieces, ew_error *error)
{
    return ew_count_path_pieces(source, core, name, pieces, error);
}

static void make(const void *source, double core, void *pieces)
{
    ew_make_path_pieces(source, core, pieces);
}

/* A straight beam has its one piece in its block. A straight piece along which t is not even counts as bent where there are
 * weights. */
static size_t piece_units(const void *source, const void *pieces, size_t piece_count)
{
    const ew_path *path = source;
    const ew_path_piece *piece = pieces;
    bool is_bent = false;
    for (size_t i = 0; i < piece_count; ++i) {
        const double *bend = piece[i].curve.polynomial[2];
        bool is_even = ew_dot(bend, bend) == 0;
        is_bent = is_bent || !piece[i].is_straight || (path->weight_count > 0 && !is_even);
    }
    if (piece_count == 1 && !is_bent && !piece->starts_at_joint && piece->domain[0] == 0 && piece->domain[1] == 1) return 0;
    return is_bent ? EW_BENT_UNITS : EW_STRAIGHT_UNITS;
}

static size_t most_piece_units(const void *source)
{
    const ew_path *path = source;
    return path->kind == EW_PATH_POLYLINE ? EW_STRAIGHT_UNITS : EW_BENT_UNITS;
}

static ew_hull hull(const void *piece)
{
    const double whole[2] = {0, 1};
    return ew_hull_of_arc(((const ew_path_piece *)piece)->curve.polynomial, whole);
}

static ew_result pack_straight(const ew_path_piece *piece, const ew_source_name *name, const ew_ray_space *space,
                               struct ew_straight_block *block, ew_error *error)
{
    double end[3], start_in_space[3], end_in_space[3];
    const double(*p)[3] = piece->curve.polynomial;
    for (int i = 0; i < 3; ++i)
        end[i] = p[0][i] + p[1][i] + p[2][i];
    ew_ray_space_place(space, p[0], start_in_space);
    ew_ray_space_place(space, end, end_in_space);
    block->start = ew_pack(start_in_space, piece->domain[0]);
    block->end = ew_pack(end_in_space, piece->domain[1]);
    ew_result result = ew_check_coordinates(name, start_in_space, error);
    return result == EW_OK ? ew_check_coordinates(name, end_in_space, error) : result;
}

static ew_result pack_bent(const ew_path_piece *piece, const ew_source_name *name, const ew_ray_space *space,
                           struct ew_bent_block *block, ew_error *error)
{
    const double whole[2] = {0, 1};
    const ew_arc arc = ew_arc_in_ray_space(space, piece->curve.polynomial, whole);
    const ew_arc_frame frame = ew_find_arc_frame(&arc);
    const ew_ball ball = ew_ball_of_arc(&arc);
    double axis[3], radius = ew_cylinder_of_arc(&arc, axis);
    block->origin = ew_pack(frame.origin, 0);
    block->axis_x = ew_pack(frame.axis_x, frame.slope_x);
    block->axis_y = ew_pack(frame.axis_y, frame.slope_y);
    block->axis_z = ew_pack(frame.axis_z, frame.bend);
    block->domain = (ew_vec4){(float)frame.first, (float)frame.last, (float)piece->domain[0], (float)piece->domain[1]};
    block->ball = ew_pack(ball.center, ball.radius);
    block->along = ew_pack(axis, radius);
    return ew_check_arc(&arc, name, error);
}

/* A straight beam is its own piece: the ball's centre is its middle. */
static ew_result pack_beam(const ew_path_piece *piece, const ew_source_name *name, const ew_ray_space *space,
                           struct ew_path_block *block, ew_error *error)
{
    double middle[3], half[3], middle_in_space[3], half_in_space[3];
    const double(*p)[3] = piece->curve.polynomial;
    for (int i = 0; i < 3; ++i) {
        half[i] = 0.5 * (p[1][i] + p[2][i]) / space->length;
        middle[i] = p[0][i] + 0.5 * (p[1][i] + p[2][i]);
    }
    ew_ray_space_place(space, middle, middle_in_space);
    ew_ray_space_turn(space, half, half_in_space);
    block->ball = ew_pack(middle_in_space, sqrt(ew_dot(half_in_space, half_in_space)));
    block->beam = ew_pack(half_in_space, 0);
    block->pieces.x = block->pieces.y = block->pieces.z = 0;
    ew_result result = ew_check_coordinates(name, middle_in_space, error);
    return result == EW_OK ? ew_check_coordinates(name, half_in_space, error) : result;
}

static ew_result pack_pieces(const ew_source_name *name, const ew_ray_space *space, const void *pieces,
                             const ew_piece_range *range, void *block, ew_vec4 *units, ew_error *error)
{
    const ew_path_piece *piece = pieces;
    struct ew_path_block *packed = block;
    if (range->piece_units == 0) return pack_beam(piece, name, space, packed, error);
    bool is_bent = range->piece_units == EW_BENT_UNITS;
    double center[3];
    ew_ray_space_place(space, range->ball.center, center);
    packed->ball = ew_pack(center, range->ball.radius / space->length);
    packed->beam = (ew_vec4){0};
    packed->pieces.x = (float)range->first_unit;
    packed->pieces.y = (float)range->piece_count;
    packed->pieces.z = is_bent;
    ew_result result = ew_check_coordinates(name, center, error);
    for (size_t i = 0; i < range->piece_count && result == EW_OK; ++i) {
        void *at = units + i * range->piece_units;
        result = is_bent ? pack_bent(&piece[i], name, space, at, error) : pack_straight(&piece[i], name, space, at, error);
    }
    return result;
}

static const char *const bend_files[] = {ew_glsl_arc_glsl,         ew_glsl_passage_glsl, ew_glsl_cell_glsl,
                                         ew_glsl_stretch_glsl,     ew_glsl_rest_glsl,    ew_glsl_knot_glsl,
                                         ew_glsl_rest_panels_glsl, ew_glsl_curve_glsl,   NULL};
static const char *const sampled_bend_files[] = {ew_glsl_polynomial_curve_glsl, ew_glsl_curve_distance_glsl, NULL};

static const ew_chain_kind chain = {.most_piece_units = most_piece_units,
                                    .list_file = ew_glsl_path_list_glsl,
                                    .bend_files = bend_files,
                                    .sampled_bend_files = sampled_bend_files,
                                    .piece_size = sizeof(ew_path_piece),
                                    .count = count,
                                    .make = make,
                                    .hull = hull,
                                    .piece_units = piece_units,
                                    .pack = pack_pieces};

extern const ew_kind ew_path_kind_row;
const ew_kind ew_path_kind_row = {
    EW_KIND_NAMES(path, PATH, paths),
    .check = check,
    .cost_in_points = 2,
    .list = EW_LIST_BEAMS,
    .bound = bound,
    .chord_file = ew_glsl_path_chord_glsl,
    .weights = weights_of,
    .pack = pack,
    .chain = &chain,
    .adaptive_files = {ew_glsl_path_pieces_glsl, ew_glsl_path_node_glsl, ew_glsl_path_slab_glsl,
                       ew_glsl_path_weighted_slab_glsl, ew_glsl_path_straight_glsl, ew_glsl_path_beam_glsl,
                       ew_glsl_path_bends_glsl, ew_glsl_path_glsl},
    .sampling_files = {ew_glsl_path_pieces_glsl, ew_glsl_path_distance_glsl},
    .irradiance_files = {ew_glsl_path_pieces_glsl, ew_glsl_polynomial_curve_glsl, ew_glsl_straight_emitter_glsl,
                         ew_glsl_bent_emitter_glsl, ew_glsl_path_irradiance_glsl},
    .gloss_files = {ew_glsl_chords_glsl, ew_glsl_path_gloss_glsl},
};
