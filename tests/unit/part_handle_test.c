/* The handles of every kind of part: where they are, and what the scene file says when they are moved. */
#include "check.h"
#include "part_handle.h"
#include "scene_file.h"

#include <stdio.h>
#include <stdlib.h>

/* The camera looks along -z; at a depth of 10, the picture is 10 units high. An arrow is a quarter of half of that long. */
static const char text[] =
    "{ \"camera\": { \"eye\": [0, 0, 10], \"target\": [0, 0, 0], \"fov_y_degrees\": 53.13010235415598 },\n"
    "  \"points\": [{ \"position\": [1.0, 2, 3], \"reach\": 1 }],\n"
    "  \"lines\": [{ \"position\": [1, 1, 0], \"direction\": [0, 3, 0], \"reach\": 1 }],\n"
    "  \"tori\": [{ \"center\": [1, 0, 0], \"axis\": [0, 2, 0], \"radius\": 2, \"reach\": 1 },\n"
    "           { \"center\": [0, 0, 0], \"axis\": [9, 0, 0], \"radius\": 3, \"reach\": 1 }],\n"
    "  \"curves\": [{ \"control_points\": [[0, 0, 0], [1, 2, 0], [3, 1, 1]], \"reach\": 1 },\n"
    "             { \"polynomial\": [[1, 2, 3], [4, 5, 6], [7, 8, 9]], \"reach\": 1 }],\n"
    "  \"paths\": [{ \"points\": [[0,0,0], [1,0,0]], \"core\": 0.1, \"reach\": 1 }],\n"
    "  \"opaque\": [{ \"shape\": \"box\", \"min\": [-1, -1, -2], \"max\": [1, 3, 0] },\n"
    "             { \"shape\": \"plane\", \"point\": [0, -1, 0], \"normal\": [0, 1, 0.0] },\n"
    "             { \"shape\": \"sphere\", \"center\": [4, 0, 0], \"radius\": 1.5 }],\n"
    "  \"media\": [{ \"shape\": \"box\", \"min\": [-2, -1, -3], \"max\": [2, 5, -1], \"extinction\": 1 },\n"
    "            { \"shape\": \"sphere\", \"center\": [0, 6, 0], \"radius\": 2.5, \"extinction\": 1 },\n"
    "            { \"shape\": \"ellipsoid\", \"center\": [7, 0, 0], \"radii\": [1, 2.0, 3], \"extinction\": 1,\n"
    "              \"axes\": [[0, 2, 0], [1, 0, 0], [0, 0, 1]] }] }\n";

static demo_scene parse(void)
{
    demo_scene scene;
    char message[256] = "";
    if (!scene_parse(text, strlen(text), "scene", &scene, message, sizeof message)) fail_msg("%s", message);
    return scene;
}

static part_handle handle_of(const demo_scene *scene, scene_part part, size_t index)
{
    return part_handle_at(scene, text, part, &scene->camera, index);
}

/* Where a handle is, and what becomes of the text when it is moved to a place by multiples of 0.01. */
static void check_handle(scene_part part, size_t index, const double position[3], const double place[3], const char *was,
                         const char *is)
{
    char expected[sizeof text + 100];
    demo_scene scene = parse();
    part_handle handle = handle_of(&scene, part, index);
    for (int i = 0; i < 3; i++)
        check_close(handle.position[i], position[i], 1e-12);
    char *moved = part_handle_move(&scene, text, part, &handle, place, 0.01);
    const char *found = strstr(text, was);
    assert_non_null(found);
    snprintf(expected, sizeof expected, "%.*s%s%s", (int)(found - text), text, is, found + strlen(was));
    assert_string_equal(moved, expected);
    free(moved);
    scene_free(&scene);
}

static void every_part_has_its_handles(void **state)
{
    (void)state;
    static const struct {
        scene_part part;
        size_t count;
    } parts[] = {{{PART_POINT, 0}, 1},  {{PART_LINE, 0}, 2},   {{PART_TORUS, 0}, 3},  {{PART_CURVE, 0}, 3},
                 {{PART_CURVE, 1}, 1},  {{PART_PATH, 0}, 2},   {{PART_OPAQUE, 0}, 3}, {{PART_OPAQUE, 1}, 2},
                 {{PART_OPAQUE, 2}, 2}, {{PART_MEDIUM, 0}, 3}, {{PART_MEDIUM, 1}, 2}, {{PART_MEDIUM, 2}, 4}};
    demo_scene scene = parse();
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        assert_int_equal(part_handle_count(&scene, text, parts[i].part), parts[i].count);
    scene_free(&scene);
}

static void positions_are_moved(void **state)
{
    (void)state;
    const double place[3] = {0.12345, -0.0001, 20.006};
#define MOVED "[0.12, 0, 20.01]"
    check_handle((scene_part){PART_POINT, 0}, 0, (double[]){1, 2, 3}, place, "[1.0, 2, 3]", MOVED);
    check_handle((scene_part){PART_LINE, 0}, 0, (double[]){1, 1, 0}, place, "[1, 1, 0]", MOVED);
    check_handle((scene_part){PART_TORUS, 0}, 0, (double[]){1, 0, 0}, place, "[1, 0, 0]", MOVED);
    check_handle((scene_part){PART_CURVE, 0}, 1, (double[]){1, 2, 0}, place, "[1, 2, 0]", MOVED);
    check_handle((scene_part){PART_CURVE, 0}, 2, (double[]){3, 1, 1}, place, "[3, 1, 1]", MOVED);
    check_handle((scene_part){PART_CURVE, 1}, 0, (double[]){1, 2, 3}, place, "[1, 2, 3]", MOVED);
    check_handle((scene_part){PART_PATH, 0}, 1, (double[]){1, 0, 0}, place, "[1,0,0]", MOVED);
    check_handle((scene_part){PART_OPAQUE, 1}, 0, (double[]){0, -1, 0}, place, "[0, -1, 0]", MOVED);
    check_handle((scene_part){PART_OPAQUE, 2}, 0, (double[]){4, 0, 0}, place, "[4, 0, 0]", MOVED);
    check_handle((scene_part){PART_MEDIUM, 1}, 0, (double[]){0, 6, 0}, place, "[0, 6, 0]", MOVED);
    check_handle((scene_part){PART_MEDIUM, 2}, 0, (double[]){7, 0, 0}, place, "[7, 0, 0]", MOVED);
}

/* An arrow of 1.25 units takes 0.001 for what is 0.01 to its end. */
static void arrows_turn_directions(void **state)
{
    (void)state;
    check_handle((scene_part){PART_LINE, 0}, 1, (double[]){1, 2.25, 0}, (double[]){4, 5, 0}, "[0, 3, 0]", "[0.6, 0.8, 0]");
    check_handle((scene_part){PART_TORUS, 0}, 1, (double[]){1, 1.25, 0}, (double[]){2, -1, -1}, "[0, 2, 0]",
                 "[0.577, -0.577, -0.577]");
    check_handle((scene_part){PART_OPAQUE, 1}, 1, (double[]){0, 0.25, 0}, (double[]){0, -1, 7}, "[0, 1, 0.0]", "[0, 0, 1]");
}

/* The radius is how far the handle is from the middle, and never nothing. */
static void radii_are_dragged(void **state)
{
    (void)state;
    check_handle((scene_part){PART_TORUS, 0}, 2, (double[]){3, 0, 0}, (double[]){4, 4, 0}, "\"radius\": 2", "\"radius\": 5");
    check_handle((scene_part){PART_TORUS, 1}, 2, (double[]){0, 3, 0}, (double[]){0, 0, 0.004}, "\"radius\": 3",
                 "\"radius\": 0.01");
    check_handle((scene_part){PART_OPAQUE, 2}, 1, (double[]){5.5, 0, 0}, (double[]){4.2, 0, 0}, "\"radius\": 1.5",
                 "\"radius\": 0.2");
    check_handle((scene_part){PART_MEDIUM, 1}, 1, (double[]){2.5, 6, 0}, (double[]){0, 6, 4}, "\"radius\": 2.5",
                 "\"radius\": 4");
}

/* Each radius of an ellipsoid ends on its own axis, along which alone it is dragged, to either side. */
static void the_radii_of_an_ellipsoid_are_dragged_along_its_axes(void **state)
{
    (void)state;
    const scene_part ellipsoid = {PART_MEDIUM, 2};
    check_handle(ellipsoid, 1, (double[]){7, 1, 0}, (double[]){9, 1.5, 3}, "[1, 2.0, 3]", "[1.5, 2, 3]");
    check_handle(ellipsoid, 2, (double[]){9, 0, 0}, (double[]){6, 8, 0}, "[1, 2.0, 3]", "[1, 1, 3]");
    check_handle(ellipsoid, 3, (double[]){7, 0, 3}, (double[]){7, 0, 0.001}, "[1, 2.0, 3]", "[1, 2, 0.01]");
}

/* A box keeps its size while its middle is dragged. A corner does not pass the other one. */
static void boxes_are_moved_and_sized(void **state)
{
    (void)state;
    const scene_part box = {PART_OPAQUE, 0};
    check_handle(box, 0, (double[]){0, 1, -1}, (double[]){0.504, 0, -1}, "\"min\": [-1, -1, -2], \"max\": [1, 3, 0]",
                 "\"min\": [-0.5, -2, -2], \"max\": [1.5, 2, 0]");
    check_handle(box, 1, (double[]){-1, -1, -2}, (double[]){0, 7, -3}, "\"min\": [-1, -1, -2]", "\"min\": [0, 2.99, -3]");
    check_handle(box, 2, (double[]){1, 3, 0}, (double[]){-5, 2, 0}, "\"max\": [1, 3, 0]", "\"max\": [-0.99, 2, 0]");
    const scene_part glass = {PART_MEDIUM, 0};
    check_handle(glass, 0, (double[]){0, 2, -2}, (double[]){1, 2, -2}, "\"min\": [-2, -1, -3], \"max\": [2, 5, -1]",
                 "\"min\": [-1, -1, -3], \"max\": [3, 5, -1]");
    check_handle(glass, 1, (double[]){-2, -1, -3}, (double[]){9, 0, -4}, "\"min\": [-2, -1, -3]", "\"min\": [1.99, 0, -4]");
    check_handle(glass, 2, (double[]){2, 5, -1}, (double[]){3, 4, 0}, "\"max\": [2, 5, -1]", "\"max\": [3, 4, 0]");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_part_has_its_handles), cmocka_unit_test(positions_are_moved),
        cmocka_unit_test(arrows_turn_directions),     cmocka_unit_test(radii_are_dragged),
        cmocka_unit_test(boxes_are_moved_and_sized),  cmocka_unit_test(the_radii_of_an_ellipsoid_are_dragged_along_its_axes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
