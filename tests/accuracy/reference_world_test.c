/*
 * The reference's world integral, and the papers' with a reach: against closed forms and brute force in extended precision.
 */
#include "brute_force.h"
#include "random_numbers.h"
#include "reference.h"
#include "reference_cases.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static double luminance_of(const ew_sources_desc *sources, const reference_ray *ray)
{
    return value_of(sources, ray).luminance;
}

/* ---- Closed forms ------------------------------------------------------------------------------------------------------- */

/* From -8 to 8 on x, at a distance from it. */
static reference_ray ray_past_the_origin(double scale, double distance)
{
    return (reference_ray){.start = {-8 * scale, distance * scale, 0},
                           .end = {-7 * scale, distance * scale, 0},
                           .s_max = HUGE_VAL,
                           .is_world = true};
}

/* The integral of 1 / max(r, sqrt(x^2 + b^2)) - 1/R over the chord of the reach. */
static double orb_luminance(double b, double core, double reach)
{
    double half = sqrt(reach * reach - b * b), inner = b < core ? sqrt(core * core - b * b) : 0;
    double outside = b > 0 ? asinh(half / b) - asinh(inner / b) : log(half / inner);
    return 2 * (outside + inner / core - half / reach);
}

static void brightness_is_the_luminance_in_the_middle(void **state)
{
    (void)state;
    static const double scales[] = {1e-3, 1, 1e4, 1e16};
    for (int i = 0; i < 4; i++) {
        double scale = scales[i];
        reference_ray ray = ray_past_the_origin(scale, 0);
        ew_point orb = {.brightness = 0.8, .core = 0.01 * scale, .reach = 2 * scale};
        ew_line beam = {.direction = {0, 3, 0}, .brightness = 0.8, .core = 0.01 * scale, .reach = 2 * scale};
        const double ends[2][3] = {{0, -5 * scale, 0}, {0, 5 * scale, 0}};
        ew_path path = {.points = ends, .point_count = 2, .brightness = 0.8, .core = 0.01 * scale, .reach = 2 * scale};
        assert_close(luminance_of(&(ew_sources_desc){.points = &orb, .point_count = 1}, &ray), 0.8, 1e-9, 0);
        assert_close(luminance_of(&(ew_sources_desc){.lines = &beam, .line_count = 1}, &ray), 0.8, 1e-9, 0);
        assert_close(luminance_of(&(ew_sources_desc){.paths = &path, .path_count = 1}, &ray), 0.8, 1e-9, 0);
    }
}

static void orbs_and_beams_match_their_closed_form(void **state)
{
    (void)state;
    static const double distances[] = {1e-6, 0.005, 0.01, 0.1, 1, 1.9, 2 - 1e-3, 2 - 1e-6};
    for (size_t i = 0; i < sizeof distances / sizeof *distances; i++) {
        reference_ray ray = ray_past_the_origin(1, distances[i]);
        ew_point orb = {.coefficient = 3, .core = 0.01, .reach = 2};
        ew_line beam = {.direction = {0, 0, 1}, .coefficient = 3, .core = 0.01, .reach = 2};
        double truth = 3 * orb_luminance(distances[i], 0.01, 2);
        assert_close(luminance_of(&(ew_sources_desc){.points = &orb, .point_count = 1}, &ray), truth, 1e-9, 0);
        assert_close(luminance_of(&(ew_sources_desc){.lines = &beam, .line_count = 1}, &ray), truth, 1e-9, 0);
    }
}

static void nothing_shines_beyond_the_reach(void **state)
{
    (void)state;
    ew_point orb = {.coefficient = 3, .core = 0.01, .reach = 2};
    ew_torus torus = {.axis = {0, 0, 1}, .radius = 1, .coefficient = 3, .core = 0.01, .reach = 1};
    ew_curve curve = {.polynomial = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, .domain = {-1, 1}, .coefficient = 3, .reach = 1};
    const ew_sources_desc fields[] = {{.points = &orb, .point_count = 1},
                                      {.tori = &torus, .torus_count = 1},
                                      {.curves = &curve, .curve_count = 1, .epsilon = 0.01}};
    for (int i = 0; i < 3; i++) {
        reference_ray ray = ray_past_the_origin(1, 2);
        assert_true(luminance_of(&fields[i], &ray) == 0);
        ray.start[1] = ray.end[1] = 2 - 1e-5;
        assert_true(luminance_of(&fields[i], &ray) > 0);
        ray.s_max = 5; /* The opaque scene is before the reach. */
        assert_true(luminance_of(&fields[i], &ray) == 0);
        ray.start[0] = 8, ray.end[0] = 9; /* The eye is behind it. */
        assert_true(luminance_of(&fields[i], &ray) == 0);
    }
}

static void cores_are_as_wide_as_pixels(void **state)
{
    (void)state;
    reference_ray ray = ray_past_the_origin(1, 0);
    ew_point orb = {.coefficient = 1, .core = 1e-9, .reach = 2};
    ew_sources_desc sources = {.points = &orb, .point_count = 1};
    ray.least_core[0] = ray.least_core[1] = 0.1;
    assert_close(luminance_of(&sources, &ray), orb_luminance(0, 0.1, 2), 1e-9, 0);
    ray.least_core[0] = ray.least_core[1] = 3;
    assert_true(luminance_of(&sources, &ray) == 0);
}

/* Regression: of a ray that is lit for a moment only, before pixels are as wide as the reach, no sample was lit. */
static void light_is_seen_up_to_where_pixels_are_as_wide_as_the_reach(void **state)
{
    (void)state;
    ew_torus torus = {.axis = {0, 0, 1}, .radius = 1, .coefficient = 1, .core = 0.12, .reach = 0.13};
    ew_sources_desc sources = {.tori = &torus, .torus_count = 1};
    const double height = 0.125, begin = 0.1 - sqrt(0.13 * 0.13 - height * height);
    reference_ray ray = {.start = {-1.1, 0, height}, .end = {-0.1, 0, height}, .s_max = 0.2, .is_world = true};
    for (double lit = 2e-4; lit < 0.03; lit *= 2) {
        ray.least_core[1] = sqrt(0.13 * 0.13 - 0.12 * 0.12) / (begin + lit);
        assert_true(luminance_of(&sources, &ray) > 0);
        assert_matches_brute_force(&sources, &ray, 1, "torus", (int)(1e4 * lit));
    }
}

/* g(x) = x^3 up to 1 and 1 + 3 (x - 1) beyond. */
static void sharpness_shapes_what_was_integrated(void **state)
{
    (void)state;
    ew_point soft = {.coefficient = 0.8 / (2 * log(200)), .core = 0.01, .reach = 2}, sharp = soft, bright = {.brightness = 0.8};
    sharp.sharpness = bright.sharpness = 3;
    bright.core = 0.01, bright.reach = 2;
    for (double distance = 0; distance < 2; distance += 0.1) {
        reference_ray ray = ray_past_the_origin(1, distance);
        double value = luminance_of(&(ew_sources_desc){.points = &soft, .point_count = 1}, &ray);
        double truth = 0.8 * pow(fmin(1, value / 0.8), 3);
        assert_close(luminance_of(&(ew_sources_desc){.points = &sharp, .point_count = 1}, &ray), truth, 1e-8, 0);
        assert_close(luminance_of(&(ew_sources_desc){.points = &bright, .point_count = 1}, &ray), truth, 1e-8, 0);
    }
    ew_line line = {.direction = {1, 0.01, 0}, .coefficient = soft.coefficient, .core = 0.01, .reach = 2};
    reference_ray ray = ray_past_the_origin(1, 0);
    double value = luminance_of(&(ew_sources_desc){.lines = &line, .line_count = 1}, &ray);
    assert_true(value > 5 * 0.8);
    line.sharpness = 3;
    assert_close(luminance_of(&(ew_sources_desc){.lines = &line, .line_count = 1}, &ray), 0.8 + 3 * (value - 0.8), 1e-9, 0);
}

static void an_endless_light_is_not_vouched_for(void **state)
{
    (void)state;
    reference_ray ray = ray_past_the_origin(1, 1);
    ew_line line = {.direction = {-7, 0, 0}, .coefficient = 1, .core = 0.01, .reach = 2};
    ew_sources_desc sources = {.lines = &line, .line_count = 1};
    reference_value value;
    assert_false(reference_luminance(workspace, &sources, &ray, &value, NULL));
    ray.s_max = 3;
    assert_close(luminance_of(&sources, &ray), 3 * (1 - 0.5), 1e-9, 0);
}

/* ---- Brute force -------------------------------------------------------------------------------------------------------- */

/* A ray of either integral, with cores of pixels or without. */
static reference_ray random_world_ray(uint64_t *random, int number)
{
    reference_ray ray = random_ray(random, 20);
    ray.is_world = number % 3 != 0;
    if (number % 2) {
        ray.least_core[1] = log_uniform(random, 1e-4, 1);
        ray.least_core[0] = ray.least_core[1] * (number % 4 == 1 ? 1 : random_unit(random));
    }
    return ray;
}

/* Barely below the reach, or much. */
static double random_core(uint64_t *random, double reach)
{
    return reach / (random_chance(random, 0.2) ? 1.01 : log_uniform(random, 1.5, 1e4));
}

static void random_sources_match_brute_force(void **state)
{
    (void)state;
    uint64_t random = 11;
    double weights[7];
    for (int i = 0; i < 7; i++)
        weights[i] = random_unit(&random);
    for (int i = 0; i < 600; i++) {
        reference_ray ray = random_world_ray(&random, i / 4);
        double reach = log_uniform(&random, 0.1, 30), core = random_core(&random, reach), place[3];
        int shape = (int)random_index(&random, CURVE_SHAPES);
        ew_point point = {.brightness = 1.5, .core = core, .reach = reach};
        ew_line line = {.coefficient = 2, .reach = reach};
        ew_torus torus = {.coefficient = 2, .radius = log_uniform(&random, 1e-2, 3), .core = core, .reach = reach};
        ew_curve curve = random_curve(&random, shape);
        point_near_ray(&random, &ray, fmin(3, reach * random_between(&random, 0, 1)), place);
        memcpy(point.position, place, sizeof place);
        memcpy(line.position, place, sizeof place);
        random_vector(&random, 1, line.direction);
        random_vector(&random, 1, torus.axis);
        for (int k = 0; k < 3; k++) {
            torus.center[k] = place[k] + torus.radius * random_between(&random, -0.7, 0.7);
            curve.polynomial[0][k] = place[k] - 0.4 * curve.polynomial[1][k] - 0.16 * curve.polynomial[2][k];
        }
        curve.reach = reach;
        if (i % 8 == 3 && !curve_is_ambiguous(shape)) curve.weights = weights, curve.weight_count = 7;
        const ew_sources_desc fields[] = {{.points = &point, .point_count = 1},
                                          {.lines = &line, .line_count = 1, .epsilon = core},
                                          {.tori = &torus, .torus_count = 1},
                                          {.curves = &curve, .curve_count = 1, .epsilon = core}};
        assert_matches_brute_force(&fields[i % 4], &ray, 2, "source", i);
    }
}

static void eyes_in_the_core_match_brute_force(void **state)
{
    (void)state;
    uint64_t random = 12;
    for (int i = 0; i < 60; i++) {
        reference_ray ray = random_world_ray(&random, i);
        ray.least_core[0] = 0;
        ew_point point = {.coefficient = 1, .core = 0.1, .reach = log_uniform(&random, 0.11, 10)};
        ew_line line = {.coefficient = 1, .core = 0.1, .reach = log_uniform(&random, 0.11, 10)};
        for (int k = 0; k < 3; k++)
            line.position[k] = point.position[k] = ray.start[k] + random_between(&random, -0.05, 0.05);
        random_vector(&random, 1, line.direction);
        assert_matches_brute_force(&(ew_sources_desc){.points = &point, .point_count = 1}, &ray, 1, "point", i);
        assert_matches_brute_force(&(ew_sources_desc){.lines = &line, .line_count = 1}, &ray, 1, "line", i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(brightness_is_the_luminance_in_the_middle),
        cmocka_unit_test(orbs_and_beams_match_their_closed_form),
        cmocka_unit_test(nothing_shines_beyond_the_reach),
        cmocka_unit_test(cores_are_as_wide_as_pixels),
        cmocka_unit_test(light_is_seen_up_to_where_pixels_are_as_wide_as_the_reach),
        cmocka_unit_test(sharpness_shapes_what_was_integrated),
        cmocka_unit_test(an_endless_light_is_not_vouched_for),
        cmocka_unit_test(random_sources_match_brute_force),
        cmocka_unit_test(eyes_in_the_core_match_brute_force),
    };
    return cmocka_run_group_tests_name("reference, world", tests, create_workspace, destroy_workspace);
}
