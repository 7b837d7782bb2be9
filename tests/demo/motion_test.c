/* Neither the demo's animation nor a camera that the user moves ever jumps. */
#include "../unit/check.h"
#include "animation.h"
#include "camera_control.h"
#include "vector.h"

#include <stdlib.h>

static double distance(const double a[3], const double b[3])
{
    double difference[3];
    vector_subtract(a, b, difference);
    return vector_length(difference);
}

/* How much a path changes: in its light, the brightness times the weights; and while it has light, in its points. */
static double path_change(const ew_path *a, const ew_path *b)
{
    double change = a->weight_count > 0 ? 0 : fabs(a->brightness - b->brightness);
    for (size_t i = 0; i < a->weight_count; i++)
        change = fmax(change, fabs(a->brightness * a->weights[i] - b->brightness * b->weights[i]));
    for (size_t i = 0; i < a->point_count && a->brightness > 0 && b->brightness > 0; i++)
        change = fmax(change, distance(a->points[i], b->points[i]));
    return change;
}

static double point_change(const ew_point *a, const ew_point *b)
{
    double change = fmax(fabs(a->brightness - b->brightness), distance(a->position, b->position));
    return fmax(change, fmax(fabs(a->core - b->core), fabs(a->reach - b->reach)));
}

static double scene_change(const demo_animation *a, const demo_animation *b)
{
    double change = fabs(a->ring.brightness - b->ring.brightness);
    if (a->ring.brightness > 0 && b->ring.brightness > 0) change = fmax(change, fabs(a->ring.radius - b->ring.radius));
    for (int i = 0; i < ANIMATION_POINTS; i++)
        change = fmax(change, point_change(&a->points[i], &b->points[i]));
    for (int i = 0; i < ANIMATION_PATHS; i++)
        change = fmax(change, path_change(&a->paths[i], &b->paths[i]));
    for (int i = 0; i < ANIMATION_MEDIA; i++)
        change = fmax(change, distance(a->media[i].ambient, b->media[i].ambient));
    return fmax(change, distance(a->scene.camera.eye, b->scene.camera.eye));
}

static demo_animation *at(double seconds)
{
    demo_animation *a = malloc(sizeof *a);
    assert_non_null(a);
    animation_init(a);
    animation_set_time(a, seconds);
    return a;
}

/* The fastest thing is the beam, which is shot 9 metres in a quarter of a second: its end moves by less than 100 metres a
 * second.
 */
static void nothing_jumps_at_any_time(void **state)
{
    (void)state;
    const double step = 1e-3;
    demo_animation *before = at(-step);
    for (double seconds = 0; seconds < ANIMATION_SECONDS + step; seconds += step) {
        demo_animation *now = at(seconds);
        double change = scene_change(before, now);
        if (change > 100 * step) fail_msg("something jumps by %g at %g seconds", change, seconds);
        free(before);
        before = now;
    }
    free(before);
}

static void a_time_has_one_scene_whatever_was_before(void **state)
{
    (void)state;
    demo_animation *a = at(7.3), *b = at(1), *c = at(7.3 - 3 * ANIMATION_SECONDS);
    animation_set_time(b, 7.3);
    check_close(scene_change(a, b), 0, 0);
    check_close(scene_change(a, c), 0, 1e-12);
    free(a);
    free(b);
    free(c);
}

static const demo_scene scene = {
    .camera = {.eye = {0, 0, 8}, .target = {0, 0, 0}, .up = {0, 1, 0}, .height = 2, .near_depth = 0.1},
    .interval_start = 3,
    .interval_end = 15};

static void the_camera_is_the_scenes_until_it_is_moved(void **state)
{
    (void)state;
    camera_control control = {0};
    demo_scene seen = camera_control_scene(&control, &scene, true);
    check_close(distance(seen.camera.eye, scene.camera.eye), 0, 0);
    check_close(seen.interval_start, 3, 0);
    camera_control_look(&control, &scene, 0, 0);
    seen = camera_control_scene(&control, &scene, true);
    check_close(distance(seen.camera.eye, scene.camera.eye), 0, 0);
    check_close(distance(seen.camera.target, scene.camera.target), 0, 1e-12);
}

static void an_orbit_keeps_its_distance_and_stops_at_the_poles(void **state)
{
    (void)state;
    camera_control control = {0};
    camera_control_orbit(&control, &scene, 90, 0);
    check_close(distance(control.camera.eye, (double[3]){8, 0, 0}), 0, 1e-12);
    for (int i = 0; i < 100; i++) {
        camera_control_orbit(&control, &scene, 3, 10);
        check_close(vector_length(control.camera.eye), 8, 1e-10);
        assert_true(control.camera.eye[1] < 7.999);
    }
    assert_true(control.camera.eye[1] > 7.9);
    check_close(vector_length(control.camera.target), 0, 0);
}

static void a_look_to_the_right_turns_about_the_eye(void **state)
{
    (void)state;
    camera_control control = {0};
    camera_control_look(&control, &scene, 90, 0);
    check_close(distance(control.camera.eye, scene.camera.eye), 0, 0);
    check_close(distance(control.camera.target, (double[3]){8, 0, 8}), 0, 1e-12);
}

static void a_flight_goes_right_up_and_forward(void **state)
{
    (void)state;
    camera_control control = {0};
    camera_control_fly(&control, &scene, (double[3]){1, 2, 3});
    check_close(distance(control.camera.eye, (double[3]){1, 2, 5}), 0, 1e-12);
    check_close(distance(control.camera.target, (double[3]){1, 2, -3}), 0, 1e-12);
}

static void the_interval_stays_around_what_is_looked_at(void **state)
{
    (void)state;
    camera_control control = {0};
    camera_control_approach(&control, &scene, 2);
    demo_scene seen = camera_control_scene(&control, &scene, true);
    check_close(seen.camera.eye[2], 4, 1e-12);
    check_close(seen.camera.height, 1, 1e-12);
    check_close(seen.interval_start, 0.1, 1e-12);
    check_close(seen.interval_end, 11, 1e-12);
    seen = camera_control_scene(&control, &scene, false);
    check_close(seen.interval_start, 3, 0);
}

static void a_scene_of_the_world_integral_stays_without_an_interval(void **state)
{
    (void)state;
    camera_control control = {0};
    demo_scene world = scene;
    world.interval_start = world.interval_end = 0;
    camera_control_approach(&control, &world, 0.5);
    demo_scene seen = camera_control_scene(&control, &world, true);
    assert_true(scene_is_world(&seen));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_jumps_at_any_time),
        cmocka_unit_test(a_time_has_one_scene_whatever_was_before),
        cmocka_unit_test(the_camera_is_the_scenes_until_it_is_moved),
        cmocka_unit_test(an_orbit_keeps_its_distance_and_stops_at_the_poles),
        cmocka_unit_test(a_look_to_the_right_turns_about_the_eye),
        cmocka_unit_test(a_flight_goes_right_up_and_forward),
        cmocka_unit_test(the_interval_stays_around_what_is_looked_at),
        cmocka_unit_test(a_scene_of_the_world_integral_stays_without_an_interval),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
