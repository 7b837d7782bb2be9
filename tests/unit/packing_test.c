/* Sources in ray space (glsl/layout.glsl): each block describes the host's source, in full precision, wherever the world is. */
#include "base/allocator.h"
#include "check.h"
#include "packed.h"
#include "plan/plan.h"

#include <stdlib.h>

static double random_number(void)
{
    return 2 * (rand() / (double)RAND_MAX) - 1;
}

static void random_vector(double v[3])
{
    for (int i = 0; i < 3; ++i)
        v[i] = random_number();
}

/* A column-major rotation about a random axis (Rodrigues), with the eye at `eye`. */
static void random_view(const double eye[3], double view[16])
{
    double axis[3], length = 0;
    random_vector(axis);
    for (int i = 0; i < 3; ++i)
        length += axis[i] * axis[i];
    length = sqrt(length);
    double angle = 3 * random_number(), c = cos(angle), s = sin(angle);
    double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
    const double rotation[3][3] = {{c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s},
                                   {y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s},
                                   {z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)}};
    memset(view, 0, 16 * sizeof *view);
    view[15] = 1;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            view[4 * column + row] = rotation[row][column];
            view[12 + row] -= rotation[row][column] * eye[column];
        }
    }
}

static ew_frame_desc random_frame(const double eye[3])
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    random_view(eye, frame.view);
    frame.interval_start = 0.5 + random_number() / 4;
    frame.interval_end = 8;
    frame.decay_alpha = 1.5;
    frame.decay_beta = 0.7;
    frame.viewport_width = frame.viewport_height = 16;
    return frame;
}

/* Where a point or (with w = 0) a vector of the world is in ray space: origin and unit as layout.glsl has them. */
static void to_ray_space(const ew_frame_desc *frame, const double world[3], double w, double out[3])
{
    double length = frame->interval_end - frame->interval_start;
    for (int row = 0; row < 3; ++row) {
        out[row] = w * frame->view[12 + row];
        for (int column = 0; column < 3; ++column)
            out[row] += frame->view[4 * column + row] * world[column];
    }
    out[2] += w * frame->interval_start; /* the anchor is at z = -interval_start */
    for (int row = 0; row < 3; ++row)
        out[row] /= length;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void from_vec4(ew_vec4 v, double out[3])
{
    out[0] = (double)v.x;
    out[1] = (double)v.y;
    out[2] = (double)v.z;
}

static void check_vector(ew_vec4 actual, const double expected[3], double tolerance)
{
    check_close((double)actual.x, expected[0], tolerance);
    check_close((double)actual.y, expected[1], tolerance);
    check_close((double)actual.z, expected[2], tolerance);
}

/* What rounding a number of about 1 to a float costs, with a little for the doubles before. */
static const double float_error = 2e-7;

static ew_sources pack(const ew_sources_desc *desc, const ew_frame_desc *frame, ew_plan *plan)
{
    ew_sources sources = {0};
    ew_error error = {EW_OK, ""};
    if (ew_sources_set(&sources, desc, &ew_default_allocator, &error) != EW_OK ||
        ew_plan_frame(plan, &sources, NULL, frame, &error) != EW_OK)
        fail_msg("refused: %s", error.text);
    return sources;
}

static double energy_of(const ew_frame_desc *frame)
{
    return frame->decay_alpha / (frame->interval_end - frame->interval_start);
}

static void check_point(const ew_point *point, const ew_frame_desc *frame, const struct ew_point_block *block)
{
    double expected[3];
    to_ray_space(frame, point->position, 1, expected);
    check_vector(block->position, expected, float_error);
    check_close((double)block->color.w, point->coefficient * energy_of(frame), float_error);
    check_vector(block->color, point->color, float_error);
}

/* The line's block is another point of the same line, the nearest to the anchor, with a unit direction. */
static void check_line(const ew_line *line, const ew_frame_desc *frame, const struct ew_line_block *block)
{
    double expected[3], direction[3], position[3];
    to_ray_space(frame, line->position, 1, expected);
    from_vec4(block->direction, direction);
    from_vec4(block->position, position);
    check_close(dot(direction, direction), 1, float_error);
    check_close(dot(direction, position), 0, float_error);
    double along = dot(expected, direction);
    for (int i = 0; i < 3; ++i)
        expected[i] -= along * direction[i];
    check_vector(block->position, expected, float_error);
    to_ray_space(frame, line->direction, 0, expected);
    check_close(dot(direction, expected), sqrt(dot(expected, expected)), float_error);
    check_close((double)block->color.w, line->coefficient * energy_of(frame), float_error);
    check_vector(block->color, line->color, float_error);
}

static void check_torus(const ew_torus *torus, const ew_frame_desc *frame, const struct ew_torus_block *block)
{
    double expected[3], axis[3];
    to_ray_space(frame, torus->center, 1, expected);
    check_vector(block->center, expected, float_error);
    to_ray_space(frame, torus->axis, 0, expected);
    from_vec4(block->axis, axis);
    check_close(dot(axis, axis), 1, float_error);
    check_close(dot(axis, expected), sqrt(dot(expected, expected)), float_error);
    check_close((double)block->axis.w, torus->radius / (frame->interval_end - frame->interval_start), float_error);
    check_close((double)block->color.w, torus->coefficient * energy_of(frame), float_error);
    check_vector(block->color, torus->color, float_error);
}

static void points_lines_and_tori_come_to_ray_space(void **state)
{
    (void)state;
    srand(2);
    for (int round = 0; round < 100; ++round) {
        double eye[3];
        random_vector(eye);
        ew_frame_desc frame = random_frame(eye);
        ew_point point = {.coefficient = 2, .color = {0.1, 0.2, 0.3}};
        ew_line line = {.coefficient = 3, .color = {0.4, 0.5, 0.6}};
        ew_torus torus = {.radius = 0.9, .coefficient = 5.1, .color = {0.7, 0.8, 0.9}};
        random_vector(point.position);
        random_vector(line.position);
        random_vector(line.direction);
        random_vector(torus.center);
        random_vector(torus.axis);
        ew_plan plan;
        ew_sources_desc desc = {.points = &point,
                                .point_count = 1,
                                .lines = &line,
                                .line_count = 1,
                                .tori = &torus,
                                .torus_count = 1,
                                .epsilon = 1e-3};
        ew_sources sources = pack(&desc, &frame, &plan);
        check_point(&point, &frame, packed_point(&sources, 0));
        check_line(&line, &frame, packed_line(&sources, 0));
        check_torus(&torus, &frame, packed_torus(&sources, 0));
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

static void the_frame_block_counts_and_scales(void **state)
{
    (void)state;
    const double eye[3] = {0};
    ew_frame_desc frame = random_frame(eye);
    frame.simpson_divisions = 128;
    ew_point points[2] = {{.coefficient = 1}, {.coefficient = 1}};
    ew_curve curves[3] = {{.domain = {0, 1}}, {.domain = {0, 1}}, {.domain = {0, 1}}};
    ew_sources_desc desc = {.points = points, .point_count = 2, .curves = curves, .curve_count = 3, .epsilon = 0.01};
    ew_plan plan;
    ew_sources sources = pack(&desc, &frame, &plan);
    const struct ew_frame_block block = plan.uniforms.frame;
    const int counts[EW_KIND_COUNT] = {2, 0, 0, 3};
    assert_memory_equal(plan.uniforms.source_counts, counts, sizeof counts);
    assert_int_equal(block.choices.x, 128);
    check_close((double)block.decay.x, 0.7, float_error);
    check_close((double)block.decay.y, 0.01 / (frame.interval_end - frame.interval_start), 1e-9);
    ew_sources_destroy(&sources, &ew_default_allocator);
}

static void finer_qualities_allow_smaller_errors(void **state)
{
    (void)state;
    const double eye[3] = {0};
    const ew_quality qualities[] = {EW_QUALITY_ERROR_1E_2, EW_QUALITY_ERROR_1E_3, EW_QUALITY_ERROR_1E_4};
    ew_frame_desc frame = random_frame(eye);
    ew_sources_desc desc = {.epsilon = 1e-3};
    float coarser = 1;
    for (size_t i = 0; i < sizeof qualities / sizeof qualities[0]; ++i) {
        frame.quality = qualities[i];
        ew_plan plan;
        ew_sources sources = pack(&desc, &frame, &plan);
        float tolerance = plan.uniforms.frame.decay.z;
        assert_true(tolerance > 0 && tolerance < coarser);
        coarser = tolerance;
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

/* The frame of the arc's plane is orthonormal and right-handed. */
static void check_axes(const struct ew_curve_block *block)
{
    double axes[3][3];
    from_vec4(block->axis_x, axes[0]);
    from_vec4(block->axis_y, axes[1]);
    from_vec4(block->axis_z, axes[2]);
    for (int i = 0; i < 3; ++i) {
        const double *x = axes[i], *y = axes[(i + 1) % 3], *z = axes[(i + 2) % 3];
        check_close(dot(x, x), 1, 2 * float_error);
        for (int k = 0; k < 3; ++k)
            check_close(x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3], z[k], 2 * float_error);
    }
}

/* The host's arc and the block's are the same point for point, tau growing evenly with t from one end to the other. */
static void check_arc(const ew_curve *curve, const ew_frame_desc *frame, const struct ew_curve_block *block, double tolerance)
{
    double origin[3], axis_x[3], axis_y[3];
    from_vec4(block->origin, origin);
    from_vec4(block->axis_x, axis_x);
    from_vec4(block->axis_y, axis_y);
    double slope_x = (double)block->axis_x.w, slope_y = (double)block->axis_y.w, bend = (double)block->axis_z.w;
    double first = (double)block->domain.x, last = (double)block->domain.y;
    assert_true(slope_x >= 0 && bend >= 0);
    check_close(last - first, 1, float_error * (1 + fabs(first)));
    for (int step = 0; step <= 8; ++step) {
        double u = step / 8.0;
        double t = curve->domain[0] + u * (curve->domain[1] - curve->domain[0]);
        double tau = first + u * (last - first);
        double x = slope_x * tau, y = (slope_y + bend * tau) * tau;
        double world[3], expected[3];
        for (int i = 0; i < 3; ++i)
            world[i] = curve->polynomial[0][i] + t * (curve->polynomial[1][i] + t * curve->polynomial[2][i]);
        to_ray_space(frame, world, 1, expected);
        for (int i = 0; i < 3; ++i)
            check_close(origin[i] + x * axis_x[i] + y * axis_y[i], expected[i], tolerance);
    }
}

static void arcs_come_to_ray_space_whatever_their_shape(void **state)
{
    (void)state;
    double shapes[][3][3] = {
        {{-1, 0, 0}, {0, 2, 0}, {1, 0, 0}},                  /* an arch */
        {{-1, 0, 0}, {1e3, 1, 0}, {-1, 0.01, 0}},            /* a hairpin */
        {{-1, 0, 0}, {1e-1, 1e-7, 0}, {1, 0, 0}},            /* nearly straight, its vertex far */
        {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}},                  /* straight, even */
        {{-1, 0, 0}, {0.9, 0, 0}, {1, 0, 0}},                /* straight, uneven */
        {{-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}},                 /* folded back on itself */
        {{0, 1, 0}, {0, 1, 0}, {2, 0, 1}},                   /* the first two coincide */
        {{2, 0, 1}, {0, 1, 0}, {0, 1, 0}},                   /* the last two coincide */
        {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, /* a point */
    };
    const double domains[][2] = {{0, 1}, {-2, 2}, {0.25, 0.5}, {-1e-3, 0}};
    srand(3);
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; ++i) {
        for (size_t j = 0; j < sizeof domains / sizeof domains[0]; ++j) {
            double eye[3];
            random_vector(eye);
            ew_frame_desc frame = random_frame(eye);
            ew_curve curve = {.domain = {domains[j][0], domains[j][1]}, .coefficient = 4, .color = {0.1, 0.2, 0.3}};
            ew_bezier_polynomial(shapes[i][0], shapes[i][1], shapes[i][2], curve.polynomial);
            ew_sources_desc desc = {.curves = &curve, .curve_count = 1, .epsilon = 1e-3};
            ew_plan plan;
            ew_sources sources = pack(&desc, &frame, &plan);
            double size = 0;
            for (int k = 0; k < 9; ++k)
                size = fmax(size, fabs(curve.polynomial[k / 3][k % 3]));
            check_arc(&curve, &frame, packed_curve(&sources, 0), 2e-6 * fmax(size, 1));
            check_axes(packed_curve(&sources, 0));
            check_close((double)packed_curve(&sources, 0)->color.w,
                        4 * frame.decay_alpha / (frame.interval_end - frame.interval_start), float_error);
            check_vector(packed_curve(&sources, 0)->color, curve.color, float_error);
            ew_sources_destroy(&sources, &ew_default_allocator);
        }
    }
}

static void an_arch_has_its_origin_at_the_vertex_and_a_straight_arc_on_itself(void **state)
{
    (void)state;
    double arch[3][3] = {{-1, 0, 0}, {0, 2, 0}, {1, 0, 0}}, straight[3][3] = {{-1, 0, 0}, {0, 1e-9, 0}, {1.1, 0, 0}};
    ew_curve curves[2] = {{.domain = {0, 1}, .coefficient = 1}, {.domain = {0, 1}, .coefficient = 1}};
    ew_bezier_polynomial(arch[0], arch[1], arch[2], curves[0].polynomial);
    ew_bezier_polynomial(straight[0], straight[1], straight[2], curves[1].polynomial);
    const double eye[3] = {0, 0, 3}, vertex[3] = {0, 1, 0};
    ew_frame_desc frame = random_frame(eye);
    ew_sources_desc desc = {.curves = curves, .curve_count = 2, .epsilon = 1e-3};
    ew_plan plan;
    ew_sources sources = pack(&desc, &frame, &plan);
    double expected[3];
    to_ray_space(&frame, vertex, 1, expected);
    check_vector(packed_curve(&sources, 0)->origin, expected, float_error);
    assert_true(packed_curve(&sources, 0)->axis_y.w == 0);
    assert_true(packed_curve(&sources, 1)->domain.x <= 0 && packed_curve(&sources, 1)->domain.y >= 0);
    ew_sources_destroy(&sources, &ew_default_allocator);
}

/* One source of each kind. */
typedef struct small_world {
    ew_point point;
    ew_line line;
    ew_torus torus;
    ew_curve curve;
} small_world;

static small_world random_world(void)
{
    small_world made = {.point = {.coefficient = 1},
                        .line = {.coefficient = 1},
                        .torus = {.radius = 1e-3, .coefficient = 1},
                        .curve = {.domain = {-1, 1}, .coefficient = 1}};
    random_vector(made.point.position);
    random_vector(made.line.position);
    random_vector(made.line.direction);
    random_vector(made.torus.center);
    random_vector(made.torus.axis);
    for (int i = 0; i < 3; ++i)
        random_vector(made.curve.polynomial[i]);
    return made;
}

static small_world moved_world(small_world moved, const double by[3])
{
    for (int i = 0; i < 3; ++i) {
        moved.point.position[i] += by[i];
        moved.line.position[i] += by[i];
        moved.torus.center[i] += by[i];
        moved.curve.polynomial[0][i] += by[i];
    }
    return moved;
}

static ew_sources_desc describe(const small_world *world)
{
    return (ew_sources_desc){.points = &world->point,
                             .point_count = 1,
                             .lines = &world->line,
                             .line_count = 1,
                             .tori = &world->torus,
                             .torus_count = 1,
                             .curves = &world->curve,
                             .curve_count = 1,
                             .epsilon = 1e-3};
}

/* The frame with its eye elsewhere. */
static ew_frame_desc seen_from(ew_frame_desc frame, const double eye[3])
{
    for (int row = 0; row < 3; ++row) {
        frame.view[12 + row] = 0;
        for (int column = 0; column < 3; ++column)
            frame.view[12 + row] -= frame.view[4 * column + row] * eye[column];
    }
    return frame;
}

/* Equal to what doubles resolve far away: their spacing at 1e5 is 1.5e-11, where a single precision sum would be off by 1e-2.
 * And either may have been rounded to the next float. */
static void check_floats(const void *far_values, const void *near_values, size_t size)
{
    for (size_t i = 0; i < size / sizeof(float); ++i) {
        double is_near = (double)((const float *)near_values)[i];
        check_close((double)((const float *)far_values)[i], is_near, 1e-9 + 1.2e-7 * fabs(is_near));
    }
}

/* The same world, moved by 1e5 units with its camera: packed, it is the same. */
static void a_world_far_from_its_origin_is_packed_as_if_it_were_near(void **state)
{
    (void)state;
    const double far_away[3] = {1e5, -1.3e5, 0.9e5};
    srand(4);
    for (int round = 0; round < 20; ++round) {
        double eye[3], far_eye[3];
        random_vector(eye);
        for (int i = 0; i < 3; ++i)
            far_eye[i] = eye[i] + far_away[i];
        const ew_frame_desc near_frame = random_frame(eye), far_frame = seen_from(near_frame, far_eye);
        const small_world near_world = random_world(), far_world = moved_world(near_world, far_away);
        const ew_sources_desc near_desc = describe(&near_world), far_desc = describe(&far_world);
        ew_plan near_plan, far_plan;
        ew_sources near_sources = pack(&near_desc, &near_frame, &near_plan);
        ew_sources far_sources = pack(&far_desc, &far_frame, &far_plan);
        assert_int_equal(near_sources.data_size, far_sources.data_size);
        check_floats(far_sources.data, near_sources.data, near_sources.data_size);
        check_floats(&far_plan.uniforms.frame, &near_plan.uniforms.frame, offsetof(struct ew_frame_block, choices));
        ew_sources_destroy(&near_sources, &ew_default_allocator);
        ew_sources_destroy(&far_sources, &ew_default_allocator);
    }
}

/* What only shows once camera and sources meet is refused by name as well. */
static void sources_beyond_what_the_shader_resolves_are_refused(void **state)
{
    (void)state;
    const double eye[3] = {0};
    ew_frame_desc frame = random_frame(eye);
    ew_point point = {.position = {1e300, 0, 0}, .coefficient = 1};
    ew_line line = {.position = {0, 1e300, 0}, .direction = {0, 0, 1}, .coefficient = 1};
    ew_torus torus = {.axis = {0, 1, 0}, .radius = 1e300, .coefficient = 1};
    ew_curve curve = {.polynomial = {{0}, {0}, {1e300, 0, 0}}, .domain = {0, 1}, .coefficient = 1};
    ew_point bright = {.coefficient = 1e300}, faint = {.coefficient = 1}, thin = {.coefficient = 1, .core = 1e-300};
    const struct {
        ew_sources_desc desc;
        const char *name;
    } cases[] = {
        {{.points = &point, .point_count = 1, .epsilon = 1e-3}, "points[0]"},
        {{.lines = &line, .line_count = 1, .epsilon = 1e-3}, "lines[0]"},
        {{.tori = &torus, .torus_count = 1, .epsilon = 1e-3}, "tori[0]"},
        {{.curves = &curve, .curve_count = 1, .epsilon = 1e-3}, "curves[0]"},
        {{.points = &bright, .point_count = 1, .epsilon = 1e-3}, "points[0].coefficient"},
        {{.points = &faint, .point_count = 1, .epsilon = 1e-300}, "epsilon"},
        {{.points = &thin, .point_count = 1}, "points[0]"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        ew_sources sources = {0};
        ew_error error = {EW_OK, ""};
        ew_plan plan;
        assert_int_equal(ew_sources_set(&sources, &cases[i].desc, &ew_default_allocator, NULL), EW_OK);
        check_refused(ew_plan_frame(&plan, &sources, NULL, &frame, &error), &error, EW_ERROR_INVALID_ARGUMENT, cases[i].name);
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

/* A world frame asks for what sources without a frame need not have. */
static void a_source_without_a_reach_is_refused_by_name_in_a_world_frame(void **state)
{
    (void)state;
    static const double places[2][3] = {{0, 0, -5}, {1, 0, -5}};
    ew_point point = {.position = {0, 0, -5}, .coefficient = 1, .core = 0.1};
    ew_line line = {.position = {0, 0, -5}, .direction = {1, 0, 0}, .coefficient = 1, .core = 0.1};
    ew_torus torus = {.center = {0, 0, -5}, .axis = {0, 1, 0}, .radius = 1, .coefficient = 1, .core = 0.1};
    ew_curve curve = {.polynomial = {{0, 0, -5}, {1, 0, 0}, {0}}, .domain = {0, 1}, .coefficient = 1, .core = 0.1};
    ew_path path = {.points = places, .point_count = 2, .coefficient = 1, .core = 0.1};
    const ew_point good = {.position = {0, 0, -4}, .brightness = 1, .core = 0.1, .reach = 1};
    const struct {
        ew_sources_desc desc;
        double *reach;
        const char *name;
    } cases[] = {
        {{.points = &point, .point_count = 1}, &point.reach, "points[0].reach"},
        {{.lines = &line, .line_count = 1, .points = &good, .point_count = 1}, &line.reach, "lines[0].reach"},
        {{.tori = &torus, .torus_count = 1, .points = &good, .point_count = 1}, &torus.reach, "tori[0].reach"},
        {{.curves = &curve, .curve_count = 1, .points = &good, .point_count = 1}, &curve.reach, "curves[0].reach"},
        {{.paths = &path, .path_count = 1, .points = &good, .point_count = 1}, &path.reach, "paths[0].reach"},
    };
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.viewport_width = frame.viewport_height = 16;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        ew_sources sources = {0};
        ew_error error = {EW_OK, ""};
        ew_plan plan;
        for (int has_reach = 0; has_reach < 2; ++has_reach) {
            *cases[i].reach = has_reach;
            assert_int_equal(ew_sources_set(&sources, &cases[i].desc, &ew_default_allocator, NULL), EW_OK);
            ew_result result = ew_plan_frame(&plan, &sources, NULL, &frame, &error);
            if (has_reach)
                assert_int_equal(result, EW_OK);
            else
                check_refused(result, &error, EW_ERROR_INVALID_ARGUMENT, cases[i].name);
        }
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

/* The host may do with its arrays what it likes once the sources are set. */
static void paths_are_copied(void **state)
{
    (void)state;
    double points[3][3] = {{0, 0, -5}, {1, 0, -5}, {1, 1, -5}}, weights[4] = {1, 2, 3, 4};
    ew_path path = {.points = (const double(*)[3])points,
                    .point_count = 3,
                    .weights = weights,
                    .weight_count = 4,
                    .brightness = 1,
                    .core = 0.1,
                    .reach = 1};
    const ew_sources_desc desc = {.paths = &path, .path_count = 1};
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.viewport_width = frame.viewport_height = 16;
    ew_plan plan;
    ew_sources kept = pack(&desc, &frame, &plan);
    char before[64 * sizeof(ew_vec4)];
    assert_true(kept.data_size <= sizeof before);
    memcpy(before, kept.data, kept.data_size);
    memset(points, 0xff, sizeof points);
    memset(weights, 0xff, sizeof weights);
    memset(&path, 0xff, sizeof path);
    memset(kept.data, 0, kept.weight_units * sizeof(ew_vec4));
    assert_int_equal(ew_plan_frame(&plan, &kept, NULL, &frame, NULL), EW_OK);
    assert_memory_equal(before, kept.data, kept.data_size);
    ew_sources_destroy(&kept, &ew_default_allocator);
}

/* b / (2 ln(R / r)), whatever the unit of length, and colours times exposure. */
static void brightness_stands_for_a_coefficient_and_exposure_for_brighter_colors(void **state)
{
    (void)state;
    static const double scales[] = {1e-3, 1, 1e4};
    for (int i = 0; i < 3; ++i) {
        double scale = scales[i];
        const ew_point orb = {.position = {0, 0, -5 * scale},
                              .brightness = 0.8,
                              .core = 0.1 * scale,
                              .reach = 2 * scale,
                              .color = {0.25, 0.5, 1}};
        const ew_sources_desc desc = {.points = &orb, .point_count = 1};
        ew_frame_desc frame = EW_FRAME_DEFAULTS;
        frame.viewport_width = frame.viewport_height = 16;
        frame.exposure = 3;
        ew_plan plan;
        ew_sources sources = pack(&desc, &frame, &plan);
        const struct ew_point_block *block = packed_point(&sources, 0);
        check_close((double)block->color.w, 0.8 / (2 * log(20)), float_error);
        check_vector(block->color, (const double[3]){0.75, 1.5, 3}, float_error);
        check_close((double)(block->glow.y / block->glow.x), 20, 20 * float_error);
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_lines_and_tori_come_to_ray_space),
        cmocka_unit_test(the_frame_block_counts_and_scales),
        cmocka_unit_test(finer_qualities_allow_smaller_errors),
        cmocka_unit_test(arcs_come_to_ray_space_whatever_their_shape),
        cmocka_unit_test(an_arch_has_its_origin_at_the_vertex_and_a_straight_arc_on_itself),
        cmocka_unit_test(a_world_far_from_its_origin_is_packed_as_if_it_were_near),
        cmocka_unit_test(sources_beyond_what_the_shader_resolves_are_refused),
        cmocka_unit_test(a_source_without_a_reach_is_refused_by_name_in_a_world_frame),
        cmocka_unit_test(paths_are_copied),
        cmocka_unit_test(brightness_stands_for_a_coefficient_and_exposure_for_brighter_colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
