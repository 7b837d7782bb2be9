/* What is under the pointer, and the shapes and rays by which it is found. */
#include "check.h"
#include "part_shape.h"
#include "scene_file.h"
#include "scene_pick.h"
#include "vector.h"

#include <stdio.h>

#define CAMERA "\"camera\": { \"eye\": [0, 0, 10], \"target\": [0, 0, 0], \"fov_y_degrees\": 53.13010235415598"
/* The picture is 10 units high at a depth of 10, and twice as wide. */
static const double aspect = 2;
#define LIGHT "\"core\": 0.1, \"reach\": 1, \"brightness\": 2"

static demo_scene parse(const char *text)
{
    demo_scene scene;
    char message[256] = "";
    if (!scene_parse(text, strlen(text), "scene", &scene, message, sizeof message)) fail_msg("%s", message);
    return scene;
}

/* Picks at a place of the picture; returns the kind, or -1 for nothing. */
static int pick(const char *text, double x, double y)
{
    demo_scene scene = parse(text);
    camera_ray ray = camera_ray_at(&scene.camera, aspect, (double[]){x, y});
    scene_part part;
    int kind = scene_pick(&scene, &ray, 0, &part) ? (int)part.kind : -1;
    scene_free(&scene);
    return kind;
}

static void check_rays(const scene_camera *camera)
{
    const double position[3] = {1, 2, -3};
    double place[2], back[3] = {4, 5, 0};
    double depth = camera_project(camera, aspect, position, place);
    camera_ray ray = camera_ray_at(camera, aspect, place);
    vector_add_scaled(ray.origin, depth, ray.direction, back);
    for (int i = 0; i < 3; i++)
        check_close(back[i], position[i], 1e-12);
    /* Moved across the view, it keeps its depth. */
    camera_move_across(camera, aspect, (double[]){0.3, -0.4}, back);
    check_close(camera_project(camera, aspect, back, place), depth, 1e-12);
    check_close(place[0], 0.3, 1e-12);
    check_close(place[1], -0.4, 1e-12);
}

static void rays_lead_back_to_what_was_projected(void **state)
{
    (void)state;
    scene_camera camera = {.eye = {5, 1, 8}, .target = {0.5, 0, 0}, .up = {0.1, 1, 0}, .fov_y_degrees = 40, .height = 3};
    check_rays(&camera);
    camera.orthographic = true;
    check_rays(&camera);
}

static void every_kind_is_found_where_it_shines(void **state)
{
    (void)state;
    static const char *const points = "{ " CAMERA " }, \"points\": [{ \"position\": [4, 1, 0], " LIGHT " }] }";
    assert_int_equal(pick(points, 0.4, 0.2), PART_POINT);
    assert_int_equal(pick(points, 0.4, 0.35), PART_POINT);
    assert_int_equal(pick(points, 0.4, 0.45), -1);
    static const char *const lines =
        "{ " CAMERA " }, \"lines\": [{ \"position\": [0, 1, 0], \"direction\": [1, 0, 0], " LIGHT " }] }";
    assert_int_equal(pick(lines, -0.9, 0.2), PART_LINE);
    assert_int_equal(pick(lines, 0.9, -0.1), -1);
    static const char *const tori =
        "{ " CAMERA " }, \"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 0, 1], \"radius\": 3, " LIGHT " }] }";
    assert_int_equal(pick(tori, 0.3, 0), PART_TORUS);
    assert_int_equal(pick(tori, 0, 0), -1);
    static const char *const curves =
        "{ " CAMERA " }, \"curves\": [{ \"control_points\": [[-4, 0, 0], [0, 6, 0], [4, 0, 0]], " LIGHT " }] }";
    assert_int_equal(pick(curves, 0, 0.6), PART_CURVE);
    assert_int_equal(pick(curves, 0, 0.1), -1);
    static const char *const paths = "{ " CAMERA " }, \"paths\": [{ \"points\": [[-4, 2, 0], [4, 2, 0]], " LIGHT " }] }";
    assert_int_equal(pick(paths, 0, 0.4), PART_PATH);
    assert_int_equal(pick(paths, 0.6, 0.4), -1);
}

static void the_brightest_is_found(void **state)
{
    (void)state;
    static const char *const text = "{ " CAMERA " }, \"points\": [{ \"position\": [0, 0, 0], " LIGHT " }],"
                                    " \"paths\": [{ \"points\": [[-4, 0.5, -1], [4, 0.5, -1]], " LIGHT " }] }";
    assert_int_equal(pick(text, 0, 0), PART_POINT);
    assert_int_equal(pick(text, 0, 0.1), PART_PATH);
}

static void walls_are_found_and_nothing_behind_them(void **state)
{
    (void)state;
#define ORB "\"points\": [{ \"position\": [0, 0, 0], " LIGHT " }]"
    static const char *const walls[] = {
        "{ \"shape\": \"box\", \"min\": [-1, -1, 1], \"max\": [1, 1, 2] }",
        "{ \"shape\": \"plane\", \"point\": [0, 0, 1], \"normal\": [0.1, 0, 1] }",
        "{ \"shape\": \"sphere\", \"center\": [0, 0, 3], \"radius\": 1 }",
    };
    for (size_t i = 0; i < sizeof walls / sizeof *walls; i++) {
        char text[600];
        snprintf(text, sizeof text, "{ " CAMERA " }, " ORB ", \"opaque\": [%s] }", walls[i]);
        assert_int_equal(pick(text, 0, 0), PART_OPAQUE);
    }
#define SPHERE "\"opaque\": [{ \"shape\": \"sphere\", \"center\": [0, 0, -3], \"radius\": 2 }]"
    static const char *const before[] = {"{ " CAMERA " }, " ORB ", " SPHERE " }",
                                         "{ " CAMERA ", \"far\": 10.5 }, " ORB ", " SPHERE " }"};
    assert_int_equal(pick(before[0], 0, 0), PART_POINT);
    assert_int_equal(pick(before[0], 0.1, 0.2), PART_OPAQUE);
    /* What is beyond the far plane is not seen. */
    assert_int_equal(pick(before[1], 0.1, 0.2), -1);
    assert_int_equal(pick("{ " CAMERA " }, \"points\": [{ \"position\": [0, 0, 13], " LIGHT " }] }", 0, 0), -1);
}

static void the_nearest_wall_is_found(void **state)
{
    (void)state;
    demo_scene scene = parse("{ " CAMERA " }, \"opaque\": [{ \"shape\": \"box\", \"min\": [-1, -1, -1], \"max\": [1, 1, 1] },"
                             " { \"shape\": \"sphere\", \"center\": [0, 0, 3], \"radius\": 1 },"
                             " { \"shape\": \"plane\", \"point\": [0, 0, -2], \"normal\": [0, 0, 1] }] }");
    const double places[3][2] = {{0.11, 0.22}, {0, 0}, {0.5, 0.5}};
    for (size_t i = 0; i < 3; i++) {
        camera_ray ray = camera_ray_at(&scene.camera, aspect, places[i]);
        scene_part part;
        assert_true(scene_pick(&scene, &ray, 0, &part));
        assert_int_equal(part.index, i);
    }
    scene_free(&scene);
}

/* A medium is found where it is entered in front of what is opaque, and sources shine through it. */
static void media_are_found_from_outside(void **state)
{
    (void)state;
#define GLASS "{ \"shape\": \"box\", \"min\": [-1, -1, 1], \"max\": [1, 1, 1.1], \"extinction\": 2 }"
#define SMOKE                                                                                                                  \
    "{ \"shape\": \"ellipsoid\", \"center\": [0, 0, 0], \"radii\": [1, 4, 2], \"extinction\": 2,"                              \
    " \"axes\": [[0, 0, 1], [1, 0, 0], [0, 1, 0]] }"
#define MEDIA(media) "{ " CAMERA " }, " SPHERE ", \"media\": [" media "] }"
    assert_int_equal(pick(MEDIA(GLASS), 0, 0), PART_MEDIUM);
    assert_int_equal(pick(MEDIA(GLASS), 0.15, 0), PART_OPAQUE);
    /* The ellipsoid is 4 wide, 2 high and 1 deep. */
    assert_int_equal(pick(MEDIA(SMOKE), 0.35, 0), PART_MEDIUM);
    assert_int_equal(pick(MEDIA(SMOKE), 0, 0.35), PART_MEDIUM);
    assert_int_equal(pick(MEDIA(SMOKE), 0.35, 0.35), -1);
    assert_int_equal(pick("{ " CAMERA " }, " ORB ", " SPHERE ", \"media\": [" GLASS "] }", 0, 0), PART_POINT);
    /* Neither what is behind, nor what stops nothing, nor what the eye is in. */
#define BALL(z, radius, extinction)                                                                                            \
    "{ \"shape\": \"sphere\", \"center\": [0, 0, " #z "], \"radius\": " #radius ", \"extinction\": " #extinction " }"
    assert_int_equal(pick(MEDIA(BALL(-3, 1, 1)), 0, 0), PART_OPAQUE);
    assert_int_equal(pick(MEDIA(BALL(3, 1, 0)), 0, 0), PART_OPAQUE);
    assert_int_equal(pick(MEDIA(BALL(9, 2, 1)), 0, 0), PART_OPAQUE);
    assert_int_equal(pick(MEDIA(BALL(3, 1, 1)), 0, 0), PART_MEDIUM);
}

/* Adds the pieces up, and checks that they hang together. */
typedef struct walk {
    double length;
    double first[3], last[3];
    int count;
} walk;

static void step(void *user, const double a[3], const double b[3])
{
    walk *w = user;
    double way[3];
    if (w->count++ == 0) {
        vector_copy(a, w->first);
    } else {
        for (int i = 0; i < 3; i++)
            check_close(a[i], w->last[i], 1e-12);
    }
    vector_subtract(b, a, way);
    w->length += vector_length(way);
    vector_copy(b, w->last);
}

static walk walk_along(const char *path)
{
    char text[600];
    snprintf(text, sizeof text, "{ " CAMERA " }, \"paths\": [{ %s, " LIGHT " }] }", path);
    demo_scene scene = parse(text);
    walk result = {0};
    part_shape(&scene, (scene_part){PART_PATH, 0}, step, &result);
    scene_free(&scene);
    return result;
}

static void check_ends(const walk *w, const double first[3], const double last[3], double length)
{
    for (int i = 0; i < 3; i++) {
        check_close(w->first[i], first[i], 1e-12);
        check_close(w->last[i], last[i], 1e-12);
    }
    check_close(w->length, length, 1e-2);
}

static void shapes_of_paths_begin_and_end_where_the_paths_do(void **state)
{
    (void)state;
#define STRAIGHT "\"points\": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]"
    static const char *const kinds[] = {"polyline", "bspline", "bezier", "catmull_rom"};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        char text[200];
        snprintf(text, sizeof text, "\"kind\": \"%s\", " STRAIGHT, kinds[i]);
        walk w = walk_along(text);
        check_ends(&w, (double[]){0, 0, 0}, (double[]){3, 0, 0}, 3);
    }
    /* A closed B-spline of a square has 4 parabolas, each from the middle of a side to that of the next and 1.6232 half sides
     * long. A Catmull-Rom spline goes through the corners, in arcs of 2.1019 half sides. Both lengths are integrated
     * numerically. */
#define SQUARE "\"closed\": true, \"points\": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]"
    walk w = walk_along("\"kind\": \"polyline\", " SQUARE);
    check_ends(&w, (double[]){0, 0, 0}, (double[]){0, 0, 0}, 8);
    w = walk_along("\"kind\": \"bspline\", " SQUARE);
    check_ends(&w, (double[]){0, 1, 0}, (double[]){0, 1, 0}, 4 * 1.6232);
    w = walk_along("\"kind\": \"catmull_rom\", " SQUARE);
    check_ends(&w, (double[]){0, 0, 0}, (double[]){0, 0, 0}, 4 * 2.1019);
}

static void add_length(void *user, const double a[3], const double b[3])
{
    double way[3];
    vector_subtract(b, a, way);
    *(double *)user += vector_length(way);
}

static double length_of_medium(const char *medium)
{
    char text[600];
    double length = 0;
    snprintf(text, sizeof text, "{ " CAMERA " }, \"media\": [{ %s, \"extinction\": 1 }] }", medium);
    demo_scene scene = parse(text);
    part_shape(&scene, (scene_part){PART_MEDIUM, 0}, add_length, &length);
    scene_free(&scene);
    return length;
}

/* A box has four edges along each axis, and a ball three circles, which are polygons of 64 sides. */
static void shapes_of_media_are_their_edges(void **state)
{
    (void)state;
    check_close(length_of_medium("\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [2, 2, 4]"), 4 * (2 + 2 + 4), 1e-12);
    double side = 2 * 2 * sin(acos(-1) / 64);
    check_close(length_of_medium("\"shape\": \"sphere\", \"center\": [1, 2, 3], \"radius\": 2"), 3 * 64 * side, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_lead_back_to_what_was_projected),
        cmocka_unit_test(every_kind_is_found_where_it_shines),
        cmocka_unit_test(the_brightest_is_found),
        cmocka_unit_test(walls_are_found_and_nothing_behind_them),
        cmocka_unit_test(the_nearest_wall_is_found),
        cmocka_unit_test(media_are_found_from_outside),
        cmocka_unit_test(shapes_of_media_are_their_edges),
        cmocka_unit_test(shapes_of_paths_begin_and_end_where_the_paths_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
