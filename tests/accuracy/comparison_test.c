/*
 * The comparison with the reference can fail: it finds the errors that a picture has. And its rays and depths are the camera's.
 */
#include "comparison.h"
#include "core_pixels.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SIDE = 40 };

/* A point and a wall behind it, before a camera with a right angle of view. */
static const char scene_text[] =
    "{\"camera\": {\"eye\": [1, 2, 3], \"target\": [1, 2, 0], \"fov_y_degrees\": 90, \"near\": 1, \"far\": 21},"
    " \"interval\": {\"start\": 2, \"end\": 12}, \"epsilon\": 0.01, \"points\": [{\"position\": [1, 2, -2]}],"
    " \"opaque\": [{\"shape\": \"sphere\", \"center\": [1, 2, -5], \"radius\": 2}]}";

static demo_scene scene;
static scene_rays rays;
static float luminance[SIDE * SIDE], depth[SIDE * SIDE];
static const drawn_picture picture = {SIDE, SIDE, luminance, depth};
static true_pixels truth;

static int create_truth(void **state)
{
    (void)state;
    char message[300];
    if (!scene_parse(scene_text, strlen(scene_text), "scene", &scene, message, sizeof message)) return -1;
    if (!scene_rays_create(&scene, SIDE, SIDE, &rays)) return -1;
    for (int i = 0; i < SIDE * SIDE; i++)
        depth[i] = 1;
    return true_pixels_compute(&rays, &picture, 0, 2, &truth) ? 0 : -1;
}

static int destroy_truth(void **state)
{
    (void)state;
    true_pixels_free(&truth);
    scene_rays_free(&rays);
    scene_free(&scene);
    return 0;
}

static void draw_truth(void)
{
    for (size_t i = 0; i < truth.count; i++)
        luminance[truth.pixels[i].y * SIDE + truth.pixels[i].x] = (float)truth.pixels[i].luminance;
}

static picture_comparison compare(void)
{
    picture_comparison comparison;
    assert_true(comparison_make(&truth, &picture, &comparison));
    return comparison;
}

static void the_truth_is_true(void **state)
{
    (void)state;
    assert_int_equal(truth.count, SIDE * SIDE);
    assert_int_equal(truth.unreliable_count, 0);
    draw_truth();
    picture_comparison comparison = compare();
    assert_true(comparison.largest_error < 1e-7);
    assert_int_equal(comparison.bad_count, 0);
}

static void one_wrong_pixel_is_found(void **state)
{
    (void)state;
    draw_truth();
    luminance[7 * SIDE + 11] *= 1.25f;
    picture_comparison comparison = compare();
    assert_true(fabs(comparison.largest_error - 0.25) < 1e-6);
    assert_int_equal(comparison.worst_x, 11);
    assert_int_equal(comparison.worst_y, 7);
    assert_true(comparison.percentile_99 < 1e-7);
}

static void the_percentile_tells_many_wrong_pixels(void **state)
{
    (void)state;
    draw_truth();
    for (int i = 0; i < SIDE * SIDE / 50; i++)
        luminance[i] *= 0.9f;
    assert_true(fabs(compare().percentile_99 - 0.1) < 1e-6);
}

static void what_is_no_luminance_is_found(void **state)
{
    (void)state;
    const float bad[] = {NAN, INFINITY, -1e-6f};
    for (int i = 0; i < 3; i++) {
        draw_truth();
        luminance[5] = bad[i];
        assert_int_equal(compare().bad_count, 1);
        if (i < 2) assert_true(isinf(compare().largest_error));
    }
}

static void samples_hold_the_brightest_pixel(void **state)
{
    (void)state;
    draw_truth();
    luminance[33 * SIDE + 9] = 1e6f;
    true_pixels sample;
    assert_true(true_pixels_compute(&rays, &picture, 100, 1, &sample));
    assert_in_range(sample.count, 50, 150);
    bool found = false;
    for (size_t i = 0; i < sample.count; i++)
        found = found || (sample.pixels[i].x == 9 && sample.pixels[i].y == 33);
    assert_true(found);
    true_pixels_free(&sample);
}

static void rays_are_the_cameras(void **state)
{
    (void)state;
    reference_ray middle = scene_rays_ray(&rays, SIDE / 2.0, SIDE / 2.0, HUGE_VAL);
    reference_ray corner = scene_rays_ray(&rays, SIDE, 0, 7);
    const double start[] = {0, 0, -2}, end[] = {0, 0, -12}, corner_end[] = {12, -12, -12};
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(middle.start[i] - start[i]) < 1e-14);
        assert_true(fabs(middle.end[i] - end[i]) < 1e-14);
        assert_true(fabs(corner.end[i] - corner_end[i]) < 1e-14);
    }
    assert_true(middle.s_max == 1);
    assert_true(fabs(corner.s_max - 0.5) < 1e-14);
    assert_true(scene_rays_ray(&rays, 0, 0, 1.5).s_max == 0);
}

/* The same camera, with no interval: rays begin at the eye, and s is the view depth. A pixel is 2 / SIDE of the view depth
 * high. */
static void world_rays_begin_at_the_eye(void **state)
{
    (void)state;
    scene_rays world = rays;
    world.is_world = true;
    world.core_pixels = 3;
    reference_ray corner = scene_rays_ray(&world, SIDE, 0, 7);
    const double direction[] = {1, -1, -1};
    for (int i = 0; i < 3; i++) {
        assert_true(corner.start[i] == 0);
        assert_true(fabs(corner.end[i] - direction[i]) < 1e-14);
    }
    assert_true(corner.is_world && corner.s_max == 7);
    assert_true(corner.least_core[0] == 0 && fabs(corner.least_core[1] - 3.0 / SIDE) < 1e-14);
    assert_true(isinf(scene_rays_pixel(&world, 3, 4, 1).s_max));
    assert_true(fabs(scene_rays_pixel(&world, 3, 4, 0.5).s_max - 21 / 11.0) < 1e-14);

    world.camera.orthographic = true;
    world.camera.height = 4;
    corner = scene_rays_ray(&world, SIDE, 0, 7);
    const double start[] = {2, -2, -1}, end[] = {2, -2, -2};
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(corner.start[i] - start[i]) < 1e-14);
        assert_true(fabs(corner.end[i] - end[i]) < 1e-14);
    }
    assert_true(corner.s_max == 6);
    assert_true(fabs(corner.least_core[0] - 6.0 / SIDE) < 1e-14 && corner.least_core[1] == corner.least_core[0]);
}

static void depths_are_the_cameras(void **state)
{
    (void)state;
    assert_true(fabs(scene_rays_stored_depth(&rays, 0) - 1) < 1e-14);
    assert_true(fabs(scene_rays_stored_depth(&rays, 1) - 21) < 1e-13);
    assert_true(fabs(scene_rays_stored_depth(&rays, 0.5) - 21 / 11.0) < 1e-14);
    /* The sphere's front is 6 before the eye; its triangles' corners lie on it. */
    assert_true(fabs(scene_rays_cast(&rays, SIDE / 2.0, SIDE / 2.0) - 6) < 0.01);
    assert_true(isinf(scene_rays_cast(&rays, 0.5, 0.5)));
}

static void places_are_seen_where_their_rays_are(void **state)
{
    (void)state;
    const double place[] = {1.5, -2, -7};
    double x, y, view_depth;
    scene_rays_project(&rays, place, &x, &y, &view_depth);
    assert_true(fabs(view_depth - 7) < 1e-14);
    reference_ray ray = scene_rays_ray(&rays, x, y, HUGE_VAL);
    for (int i = 0; i < 3; i++) /* 7 is half way from 2 to 12 */
        assert_true(fabs(0.5 * (ray.start[i] + ray.end[i]) - place[i]) < 1e-14);
}

static void stored_depths_are_those_that_are_read(void **state)
{
    (void)state;
    for (double view_depth = 1; view_depth < 21; view_depth += 0.7)
        assert_true(fabs(scene_rays_stored_depth(&rays, (double)scene_rays_depth_to_store(&rays, view_depth)) - view_depth) <
                    1e-6 * view_depth * view_depth);
    assert_true(scene_rays_depth_to_store(&rays, HUGE_VAL) == 1);
}

/* The point is at (20, 20), 5 before the eye. */
static void core_pixels_are_around_the_source(void **state)
{
    (void)state;
    uint64_t random = 1;
    int found = 0, close = 0;
    for (int i = 0; i < 1000; i++) {
        int x, y;
        if (!random_core_pixel(&rays, &random, &x, &y)) continue;
        assert_true(x >= 0 && x < SIDE && y >= 0 && y < SIDE);
        found++;
        close += abs(x - SIDE / 2) <= 4 && abs(y - SIDE / 2) <= 4;
    }
    assert_true(found > 500);
    assert_true(close > found / 2);
}

static void a_depth_that_is_not_the_scenes_is_found(void **state)
{
    (void)state;
    /* The buffer is empty, but the sphere is not. */
    assert_true(depth_misses(&rays, &truth, &picture) > 0);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double z = fmin(21, scene_rays_cast(&rays, i % SIDE + 0.5, i / SIDE + 0.5));
        depth[i] = (float)((1 - 1 / z) / (1 - 1 / 21.0));
    }
    assert_int_equal(depth_misses(&rays, &truth, &picture), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_truth_is_true),
        cmocka_unit_test(one_wrong_pixel_is_found),
        cmocka_unit_test(the_percentile_tells_many_wrong_pixels),
        cmocka_unit_test(what_is_no_luminance_is_found),
        cmocka_unit_test(samples_hold_the_brightest_pixel),
        cmocka_unit_test(rays_are_the_cameras),
        cmocka_unit_test(world_rays_begin_at_the_eye),
        cmocka_unit_test(depths_are_the_cameras),
        cmocka_unit_test(places_are_seen_where_their_rays_are),
        cmocka_unit_test(stored_depths_are_those_that_are_read),
        cmocka_unit_test(core_pixels_are_around_the_source),
        cmocka_unit_test(a_depth_that_is_not_the_scenes_is_found),
    };
    return cmocka_run_group_tests_name("comparison", tests, create_truth, destroy_truth);
}
