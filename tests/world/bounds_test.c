/* What ew_get_bounds says is true of pictures: no pixel is lit outside, and the rectangle is no larger than it must be.
 *
 *     bounds_test CONTEXT    one of the names in context.h */
#include "program_context.h"
#include "stage.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static ew_bounds bounds_of(const ew_frame_desc *frame)
{
    ew_bounds bounds;
    ew_error error = {.text = ""};
    if (ew_get_bounds(stage_effect(), frame, &bounds, &error) != EW_OK) fail_msg("%s", error.text);
    return bounds;
}

static bool is_empty(const ew_bounds *bounds)
{
    return bounds->width == 0 || bounds->height == 0;
}

static bool is_whole(const ew_bounds *bounds)
{
    return bounds->x == 0 && bounds->y == 0 && bounds->width == STAGE_WIDTH && bounds->height == STAGE_HEIGHT;
}

/* Draws, and expects every lit pixel to be within the bounds. Returns how many are lit. */
static int check_lit_pixels(const ew_frame_desc *frame, const char *what, unsigned number)
{
    static stage_picture found;
    ew_bounds bounds = bounds_of(frame);
    int lit = 0;
    stage_measure(frame, found);
    for (int row = 0; row < STAGE_HEIGHT; row++)
        for (int column = 0; column < STAGE_WIDTH; column++) {
            if (found[row][column][0] == 0) continue;
            lit++;
            if (column >= bounds.x && column < bounds.x + bounds.width && row >= bounds.y && row < bounds.y + bounds.height)
                continue;
            fail_msg("%s, scene %u: pixel (%d, %d) has %g, outside of %d, %d, %d x %d", what, number, column, row,
                     (double)found[row][column][0], bounds.x, bounds.y, bounds.width, bounds.height);
        }
    return lit;
}

/* ---- Random scenes ------------------------------------------------------------------------------------------------------ */

static double between(double low, double high)
{
    return low + (high - low) * rand() / RAND_MAX;
}

static void random_vector(double size, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = between(-size, size);
}

typedef enum kind { POINT, LINE, TORUS, CURVE, POLYLINE, BSPLINE, BEZIER, CATMULL_ROM, KIND_COUNT } kind;

static const char *const kind_names[] = {"point",    "line",     "torus",       "curve",
                                         "polyline", "B-spline", "Bezier path", "Catmull-Rom"};

typedef struct scene {
    ew_point point;
    ew_line line;
    ew_torus torus;
    ew_curve curve;
    ew_path path;
    double points[7][3];
    ew_sources_desc desc;
} scene;

static void random_scene(scene *made, kind of, double reach)
{
    double place[3];
    *made = (scene){.desc = {.points = &made->point,
                             .point_count = of == POINT,
                             .lines = &made->line,
                             .line_count = of == LINE,
                             .tori = &made->torus,
                             .torus_count = of == TORUS,
                             .curves = &made->curve,
                             .curve_count = of == CURVE,
                             .paths = &made->path,
                             .path_count = of >= POLYLINE,
                             .epsilon = 1e-3}};
    random_vector(6, place);
    made->point = (ew_point){.brightness = 1, .reach = reach};
    made->line = (ew_line){.brightness = 1, .reach = reach};
    made->torus = (ew_torus){.brightness = 1, .reach = reach, .radius = between(0, 2)};
    made->curve = (ew_curve){.brightness = 1, .reach = reach, .domain = {between(-1, 0), between(0.5, 1.5)}};
    memcpy(made->point.position, place, sizeof place);
    memcpy(made->line.position, place, sizeof place);
    memcpy(made->torus.center, place, sizeof place);
    memcpy(made->curve.polynomial[0], place, sizeof place);
    random_vector(1, made->line.direction);
    random_vector(1, made->torus.axis);
    random_vector(3, made->curve.polynomial[1]);
    random_vector(3, made->curve.polynomial[2]);
    for (int i = 0; i < 7; i++) {
        random_vector(2, made->points[i]);
        for (int k = 0; k < 3; k++)
            made->points[i][k] += place[k];
    }
    made->path = (ew_path){.kind = (ew_path_kind)(of >= POLYLINE ? of - POLYLINE : 0),
                           .points = (const double(*)[3])made->points,
                           .point_count = of == BEZIER ? 7 : (size_t)between(3, 7.99),
                           .is_closed = of != BEZIER && rand() % 3 == 0,
                           .brightness = 1,
                           .core = 0.02,
                           .reach = reach};
}

/* Turned about y and x, off-axis or parallel, near and far. */
static ew_frame_desc random_frame(void)
{
    double distance = between(0.5, 12), cy = cos(between(-3, 3)), sy = sqrt(1 - cy * cy), cx = cos(between(-1, 1));
    double sx = sqrt(1 - cx * cx);
    const double rotation[3][3] = {{cy, 0, sy}, {sx * sy, cx, -sx * cy}, {-cx * sy, sx, cx * cy}};
    ew_frame_desc frame = stage_frame(distance);
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            frame.view[4 * column + row] = rotation[row][column];
    if (rand() % 3 == 0) {
        frame.projection[8] = between(-0.8, 0.8);
        frame.projection[9] = between(-0.8, 0.8);
    }
    if (rand() % 3 == 0) { /* the size of what the perspective view shows at `distance` */
        double *p = frame.projection, near_depth = distance / 100, far_depth = 100 * distance;
        p[0] /= distance;
        p[5] /= distance;
        p[8] = p[9] = p[11] = 0;
        p[10] = -2 / (far_depth - near_depth);
        p[14] = -(far_depth + near_depth) / (far_depth - near_depth);
        p[15] = 1;
    }
    frame.core_pixels = rand() % 2 ? EW_CORE_PIXELS_DEFAULT : 0;
    return frame;
}

static void no_pixel_is_lit_outside(void **state)
{
    (void)state;
    srand(13);
    for (int of = 0; of < KIND_COUNT; of++) {
        int lit_scenes = 0;
        for (unsigned number = 0; number < 40; number++) {
            scene made;
            random_scene(&made, (kind)of, between(0.05, 2.5));
            ew_frame_desc frame = random_frame();
            stage_set(&made.desc);
            lit_scenes += check_lit_pixels(&frame, kind_names[of], number) > 0;
            frame.interval_start = between(0.5, 5);
            frame.interval_end = frame.interval_start + between(0.5, 10);
            check_lit_pixels(&frame, kind_names[of], number);
        }
        assert_true(lit_scenes > 10);
    }
}

/* Several sources share one rectangle. */
static void all_sources_are_within(void **state)
{
    (void)state;
    srand(14);
    for (unsigned number = 0; number < 40; number++) {
        scene made;
        random_scene(&made, POINT, between(0.05, 1));
        made.desc.torus_count = made.desc.curve_count = made.desc.path_count = 1;
        random_vector(5, made.torus.center);
        random_vector(5, made.curve.polynomial[0]);
        ew_frame_desc frame = random_frame();
        stage_set(&made.desc);
        check_lit_pixels(&frame, "a mix", number);
    }
}

/* ---- How tight they are ------------------------------------------------------------------------------------------------- */

static ew_point make_orb(double x, double y, double z, double reach)
{
    return (ew_point){.position = {x, y, z}, .brightness = 1, .core = reach / 10, .reach = reach};
}

static void set_orb(const ew_point *orb)
{
    stage_set(&(ew_sources_desc){.points = orb, .point_count = 1});
}

/* The silhouette of a ball, in pixels, and little more. */
static void an_orbs_rectangle_is_little_larger_than_the_orb(void **state)
{
    (void)state;
    for (double distance = 6; distance < 60; distance *= 1.5) {
        const double reach = 1;
        const ew_point orb = make_orb(0.2, 0.1, 0, reach);
        set_orb(&orb);
        ew_frame_desc frame = stage_frame(distance);
        ew_bounds bounds = bounds_of(&frame);
        double silhouette = 2 * reach / sqrt(distance * distance - reach * reach) * distance / stage_pixel(distance);
        assert_true(bounds.width >= silhouette && bounds.height >= silhouette);
        assert_true(bounds.width <= 1.25 * silhouette + 2 && bounds.height <= 1.25 * silhouette + 2);
        assert_true(fabs(bounds.depth_start - (distance - reach)) <= 1e-9 * distance);
        assert_true(fabs(bounds.depth_end - (distance + reach)) <= 1e-9 * distance);
    }
}

static void what_is_not_in_view_has_no_rectangle(void **state)
{
    (void)state;
    static const double places[][3] = {{0, 0, 8.1}, {0, 0, 100}, {30, 0, 0}, {-30, 0, 0}, {0, 30, 0}, {0, -30, 0}};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        const ew_point orb = make_orb(places[i][0], places[i][1], places[i][2], 2);
        set_orb(&orb);
        ew_frame_desc frame = stage_frame(6);
        ew_bounds bounds = bounds_of(&frame);
        assert_true(is_empty(&bounds));
    }
    stage_set(&(ew_sources_desc){.epsilon = 1});
    ew_frame_desc frame = stage_frame(6);
    ew_bounds bounds = bounds_of(&frame);
    assert_true(is_empty(&bounds));
}

static void an_eye_in_the_light_is_told(void **state)
{
    (void)state;
    static const double distances[] = {0.01, 0.5, 1.9};
    for (int i = 0; i < 3; i++) {
        const ew_point orb = make_orb(0, 0, 0, 2);
        set_orb(&orb);
        ew_frame_desc frame = stage_frame(distances[i]);
        ew_bounds bounds = bounds_of(&frame);
        assert_true(bounds.depth_start <= 0 && is_whole(&bounds));
        assert_true(fabs(bounds.depth_end - (distances[i] + 2)) < 1e-9);
    }
}

static void an_infinite_line_has_no_end(void **state)
{
    (void)state;
    const ew_line line = {.position = {0, 0, 0}, .direction = {1, 0.2, -0.5}, .brightness = 1, .core = 0.1, .reach = 1};
    stage_set(&(ew_sources_desc){.lines = &line, .line_count = 1});
    ew_frame_desc frame = stage_frame(6);
    ew_bounds bounds = bounds_of(&frame);
    assert_true(isinf(bounds.depth_end) && bounds.depth_start <= 0);
    assert_true(bounds.width == STAGE_WIDTH && bounds.height < STAGE_HEIGHT);
}

/* The papers' interval bounds what has no reach, and cuts what has one. */
static void an_interval_bounds_the_depths(void **state)
{
    (void)state;
    ew_point orb = make_orb(0, 0, 0, 2);
    ew_frame_desc frame = stage_frame(6);
    frame.interval_start = 5;
    frame.interval_end = 7;
    set_orb(&orb);
    ew_bounds bounds = bounds_of(&frame);
    assert_true(bounds.depth_start == 5 && bounds.depth_end == 7 && !is_empty(&bounds) && !is_whole(&bounds));
    frame.interval_start = 1;
    frame.interval_end = 20;
    bounds = bounds_of(&frame);
    assert_true(fabs(bounds.depth_start - 4) < 1e-9 && fabs(bounds.depth_end - 8) < 1e-9);
    frame.interval_start = 9;
    bounds = bounds_of(&frame);
    assert_true(is_empty(&bounds));
    orb = (ew_point){.coefficient = 1, .core = 0.1};
    set_orb(&orb);
    bounds = bounds_of(&frame);
    assert_true(bounds.depth_start == 9 && bounds.depth_end == 20 && is_whole(&bounds));
}

/* The rectangle is in pixels of the target. */
static void a_viewport_moves_the_rectangle(void **state)
{
    (void)state;
    const ew_point orb = make_orb(0.5, 0.2, 0, 0.5);
    set_orb(&orb);
    ew_frame_desc frame = stage_frame(6);
    ew_bounds at_origin = bounds_of(&frame);
    frame.viewport_x = -30;
    frame.viewport_y = 1000;
    ew_bounds moved = bounds_of(&frame);
    assert_int_equal(moved.x, at_origin.x - 30);
    assert_int_equal(moved.y, at_origin.y + 1000);
    assert_int_equal(moved.width, at_origin.width);
    assert_int_equal(moved.height, at_origin.height);
}

static void bad_arguments_change_nothing(void **state)
{
    (void)state;
    ew_frame_desc frame = stage_frame(6);
    ew_bounds bounds, before;
    ew_error error = {.text = ""};
    memset(&bounds, 0x5a, sizeof bounds);
    before = bounds;
    assert_int_equal(ew_get_bounds(NULL, &frame, &bounds, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "effect"));
    assert_int_equal(ew_get_bounds(stage_effect(), NULL, &bounds, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "frame"));
    assert_int_equal(ew_get_bounds(stage_effect(), &frame, NULL, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "bounds"));
    frame.viewport_width = 0;
    assert_int_equal(ew_get_bounds(stage_effect(), &frame, &bounds, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "viewport_width"));
    assert_memory_equal(&bounds, &before, sizeof bounds);
}

int main(int argc, char **argv)
{
    if (argc != 2 || !stage_open(argv[1])) return 2;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pixel_is_lit_outside),
        cmocka_unit_test(all_sources_are_within),
        cmocka_unit_test(an_orbs_rectangle_is_little_larger_than_the_orb),
        cmocka_unit_test(what_is_not_in_view_has_no_rectangle),
        cmocka_unit_test(an_eye_in_the_light_is_told),
        cmocka_unit_test(an_infinite_line_has_no_end),
        cmocka_unit_test(an_interval_bounds_the_depths),
        cmocka_unit_test(a_viewport_moves_the_rectangle),
        cmocka_unit_test(bad_arguments_change_nothing),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    stage_close();
    return failed;
}
