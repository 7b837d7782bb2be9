/* Bounds against places that sources light: a place is lit if it is within reach of a point of the source. All such places that
 * are seen are within the bounds, and the bounds are little larger than they must be. */
#include "base/allocator.h"
#include "check.h"
#include "lit_scene.h"
#include "plan/plan.h"

enum { SIZE = LIT_SCENE_SIZE, SCENES = 60, PLACES = 20000 };

static ew_bounds bounds_of(const ew_sources_desc *desc, const ew_frame_desc *frame)
{
    ew_sources sources = {0};
    ew_bounds bounds = {0};
    ew_error error = {EW_OK, ""};
    if (ew_sources_set(&sources, desc, &ew_default_allocator, &error) != EW_OK ||
        ew_plan_bounds(&sources, frame, &bounds, &error) != EW_OK)
        fail_msg("%s", error.text);
    ew_sources_destroy(&sources, &ew_default_allocator);
    return bounds;
}

static double area(const ew_bounds *bounds)
{
    return (double)bounds->width * bounds->height;
}

static bool is_in_viewport(const double seen[3])
{
    return fabs(seen[0]) < 1 && fabs(seen[1]) < 1;
}

static void no_lit_place_is_outside(void **state)
{
    uint64_t random = 1;
    (void)state;
    for (int k = 0; k < SOURCE_KIND_COUNT; ++k) {
        const source_kind *kind = source_kinds[k];
        for (int number = 0, visible = 0; number < SCENES; ++number) {
            lit_scene made;
            lit_scene_make(&made, kind, &random);
            const ew_bounds bounds = bounds_of(&made.desc, &made.frame);
            for (int i = 0; i < PLACES; ++i) {
                double place[3], seen[3];
                lit_scene_place(&made, kind, &random, place);
                if (!lit_scene_project(&made.frame, place, seen) || !is_in_viewport(seen)) continue;
                double x = (0.5 * seen[0] + 0.5) * SIZE, y = (0.5 * seen[1] + 0.5) * SIZE;
                ++visible;
                if (x < bounds.x || x > bounds.x + bounds.width || y < bounds.y || y > bounds.y + bounds.height ||
                    seen[2] < bounds.depth_start || seen[2] > bounds.depth_end)
                    fail_msg("%s, scene %d: (%g, %g) at depth %g is lit, outside of %d, %d, %d x %d, %g to %g", kind->name,
                             number, x, y, seen[2], bounds.x, bounds.y, bounds.width, bounds.height, bounds.depth_start,
                             bounds.depth_end);
            }
            if (number == SCENES - 1) assert_true(visible > SCENES * PLACES / 20);
        }
    }
}

/* ---- How tight they are ------------------------------------------------------------------------------------------------- */

/* The area around all lit places that are seen. A line's are looked for in the viewport; of others the viewport cuts each axis
 * regardless of the other one. */
static double sampled_area(lit_scene *made, const source_kind *kind, uint64_t *random)
{
    double low[2] = {1, 1}, high[2] = {-1, -1};
    for (int i = 0; i < PLACES; ++i) {
        double place[3], seen[3];
        lit_scene_place(made, kind, random, place);
        if (!lit_scene_project(&made->frame, place, seen) || (kind->is_endless && !is_in_viewport(seen))) continue;
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = fmax(fmin(low[axis], seen[axis]), -1);
            high[axis] = fmin(fmax(high[axis], seen[axis]), 1);
        }
    }
    if (low[0] >= high[0] || low[1] >= high[1]) return 0;
    return (0.5 * SIZE * (high[0] - low[0]) + 2) * (0.5 * SIZE * (high[1] - low[1]) + 2);
}

static void rectangles_are_little_larger_than_the_light(void **state)
{
    (void)state;
    for (int k = 0; k < SOURCE_KIND_COUNT; ++k) {
        uint64_t random = 2;
        double found = 0, sampled = 0;
        for (int number = 0; number < SCENES; ++number) {
            lit_scene made;
            lit_scene_make(&made, source_kinds[k], &random);
            const ew_bounds bounds = bounds_of(&made.desc, &made.frame);
            found += area(&bounds);
            sampled += sampled_area(&made, source_kinds[k], &random);
        }
        print_message("%s: %.3f times the light's area\n", source_kinds[k]->name, found / sampled);
        if (!(found <= 1.15 * sampled)) fail();
    }
}

static ew_point make_orb(double x, double y, double z, double reach)
{
    return (ew_point){.position = {x, y, z}, .coefficient = 1, .core = 1e-3, .reach = reach};
}

/* What is seen of it, from -1 to 1, are the angles from its middle to the tangents. */
static void a_ball_across_the_eyes_plane_ends_at_its_tangent(void **state)
{
    (void)state;
    const ew_frame_desc frame = lit_scene_plain_frame();
    for (double z = -1.4; z < 1; z += 0.4) {
        const ew_point orb = make_orb(1.5, 0, z, 1);
        const ew_bounds bounds = bounds_of(&(ew_sources_desc){.points = &orb, .point_count = 1}, &frame);
        double tangent = tan(atan2(1.5, -z) - asin(1 / hypot(1.5, z)));
        assert_true(bounds.x == (tangent < 1 ? floor((0.5 * tangent + 0.5) * SIZE) : 0));
        assert_true(bounds.width == (tangent < 1 ? SIZE - bounds.x : 0));
    }
}

static void light_beside_the_eye_off_screen_has_no_rectangle(void **state)
{
    (void)state;
    const ew_frame_desc frame = lit_scene_plain_frame();
    const ew_point orbs[] = {make_orb(6, 0, 0, 2), make_orb(-6, 0, -0.5, 2), make_orb(0, 6, 0.5, 2), make_orb(0, -6, 0, 2)};
    const ew_line lines[] = {
        {.position = {0, 12, -5}, .direction = {1, 0, 0}, .coefficient = 1, .core = 1e-3, .reach = 2},
        {.position = {-12, 0, -5}, .direction = {0, 1, 0}, .coefficient = 1, .core = 1e-3, .reach = 2},
        {.position = {-12, 12, -6}, .direction = {1, 1, 0}, .coefficient = 1, .core = 1e-3, .reach = 2},
        {.position = {0, 0, 3}, .direction = {1, -1, 0}, .coefficient = 1, .core = 1e-3, .reach = 2},
    };
    const double corners[][3] = {{-20, -20, -8}, {20, -20, -8}, {20, 20, -8}, {-20, 20, -8}};
    const ew_path around = {.points = corners, .point_count = 4, .is_closed = 1, .coefficient = 1, .core = 1e-3, .reach = 2};
    const ew_sources_desc descs[] = {
        {.points = orbs, .point_count = 4}, {.lines = lines, .line_count = 4}, {.paths = &around, .path_count = 1}};
    for (int i = 0; i < 3; ++i) {
        const ew_bounds bounds = bounds_of(&descs[i], &frame);
        if (area(&bounds) > 0) fail_msg("case %d: %d, %d, %d x %d", i, bounds.x, bounds.y, bounds.width, bounds.height);
    }
}

/* Beside the view's axis it runs to the middle, or in a parallel view it is a disc. */
static void a_line_along_the_view_is_not_everywhere(void **state)
{
    (void)state;
    ew_frame_desc frame = lit_scene_plain_frame();
    const ew_line line = {.position = {3, 0, 0}, .direction = {0, 0, 1}, .coefficient = 1, .core = 1e-3, .reach = 1};
    const ew_sources_desc desc = {.lines = &line, .line_count = 1};
    ew_bounds bounds = bounds_of(&desc, &frame);
    assert_int_equal(bounds.x, SIZE / 2);
    assert_int_equal(bounds.width, SIZE / 2);
    assert_true(bounds.height >= SIZE / sqrt(8) && bounds.height <= SIZE / sqrt(8) + 2);
    lit_scene_make_parallel(&frame, 8);
    bounds = bounds_of(&desc, &frame);
    assert_int_equal(bounds.x, SIZE * 5 / 8);
    assert_int_equal(bounds.width, SIZE / 8);
    assert_true(bounds.height >= SIZE / 8 && bounds.height <= SIZE / 8 + 2);
}

static void a_world_frame_needs_reaches(void **state)
{
    (void)state;
    const ew_point orbs[] = {make_orb(0, 0, -5, 1), make_orb(0, 0, -5, 1), make_orb(0, 0, -5, 0)};
    const ew_line line = {.direction = {1, 0, 0}, .coefficient = 1, .core = 1e-3, .reach = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_plan plan;
    ew_bounds bounds = {.x = -7};
    ew_error of_bounds, of_draw;
    const ew_sources_desc desc = {.points = orbs, .point_count = 3, .lines = &line, .line_count = 1};
    assert_int_equal(ew_sources_set(&sources, &desc, &ew_default_allocator, NULL), EW_OK);
    check_refused(ew_plan_frame(&plan, &sources, NULL, &frame, &of_draw), &of_draw, EW_ERROR_INVALID_ARGUMENT,
                  "points[2].reach");
    assert_int_equal(ew_plan_bounds(&sources, &frame, &bounds, &of_bounds), EW_ERROR_INVALID_ARGUMENT);
    assert_string_equal(of_bounds.text, of_draw.text);
    assert_int_equal(bounds.x, -7);
    ew_sources_destroy(&sources, &ew_default_allocator);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_lit_place_is_outside),
        cmocka_unit_test(rectangles_are_little_larger_than_the_light),
        cmocka_unit_test(a_ball_across_the_eyes_plane_ends_at_its_tangent),
        cmocka_unit_test(light_beside_the_eye_off_screen_has_no_rectangle),
        cmocka_unit_test(a_line_along_the_view_is_not_everywhere),
        cmocka_unit_test(a_world_frame_needs_reaches),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
