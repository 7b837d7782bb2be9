/* The scene file: what it says arrives, and what is wrong with it is named with its place. */
#include "check.h"
#include "scene_file.h"
#include "scene_write.h"

#include <stdio.h>
#include <stdlib.h>

#define CAMERA "\"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0] }"
#define INTERVAL "\"interval\": { \"start\": 3, \"end\": 15 }"
/* A scene of each integral. */
#define PAPER(members) "{ " CAMERA ", " INTERVAL ", " members " }"
#define WORLD(members) "{ " CAMERA ", " members " }"
#define BEAM "\"points\": [[0, 0, 0], [1, 0, 0]]"
#define BALL "\"shape\": \"sphere\", \"center\": [0, 0, 0]"
#define BLOCK "\"shape\": \"box\", \"min\": [0, 0, 0]"
#define EGG "\"shape\": \"ellipsoid\", \"center\": [0, 0, 0]"
#define ARC "\"control_points\": [[0, 0, 0], [1, 1, 0], [2, 0, 0]]"

static const char full_scene[] =
    "{ \"version\": 1, \"comment\": \"everything\",\n"
    "  \"camera\": { \"eye\": [1, 2, 8], \"target\": [0.5, 0, 0], \"up\": [0, 0, 1], \"fov_y_degrees\": 60,"
    " \"near\": 0.5, \"far\": 50 },\n"
    "  \"interval\": { \"start\": 3, \"end\": 15 }, \"decay\": { \"alpha\": 2, \"beta\": 0.5 }, \"epsilon\": 0.01,\n"
    "  \"core_pixels\": 2, \"exposure\": 3, \"light\": { \"gain\": 20, \"reach\": 8, \"shadow_thickness\": 0.5 },\n"
    "  \"fog\": { \"extinction\": 0.3, \"height\": { \"base\": -1, \"scale\": 4, \"up\": [0, 0, 2] } },\n"
    "  \"media\": [{ \"shape\": \"box\", \"min\": [0, 1, 2], \"max\": [3, 5, 8], \"extinction\": 0.5 },\n"
    "    { \"shape\": \"sphere\", \"center\": [1, 2, 3], \"radius\": 4, \"extinction\": 6, \"albedo\": 0.25, \"ambient\": [7, "
    "8, 9] },\n"
    "    { \"shape\": \"ellipsoid\", \"center\": [1, 2, 3], \"radii\": [4, 5, 6], \"axes\": [[0, 2, 0], [0, 0, -3], [1, 0, 0]],"
    " \"extinction\": 7 }],\n"
    "  \"background\": [0.1, 0.2, 0.3], \"color\": [0.4, 0.5, 0.6], \"composite\": \"add\",\n"
    "  \"points\": [{ \"name\": \"orb\", \"position\": [100000.0000001, 2, 3], \"coefficient\": 4, \"color\": [5, 6, 7] }],\n"
    "  \"lines\": [{ \"position\": [1, 2, 3], \"direction\": [0, 0, 5], \"core\": 0.02 }],\n"
    "  \"tori\": [{ \"center\": [1, 2, 3], \"axis\": [0, 2, 0], \"radius\": 0.9, \"coefficient\": 5.1 }],\n"
    "  \"curves\": [{ \"control_points\": [[0, 0, 0], [1, 2, 0], [2, 0, 0]], \"weights\": [1, 0.2, 0.6] },\n"
    "    { \"polynomial\": [[1, 2, 3], [4, 5, 6], [7, 8, 9]], \"domain\": [-2, 2] }],\n"
    "  \"paths\": [{ \"points\": [[1, 2, 3], [4, 5, 6]], \"core\": 0.05, \"reach\": 1.5, \"brightness\": 0.8,"
    " \"sharpness\": 2, \"color\": [1, 2, 3] },\n"
    "    { \"kind\": \"catmull_rom\", \"closed\": true, \"points\": [[0, 0, 0], [1, 0, 0], [1, 1, 0]], \"weights\": [1, 2] "
    "}],\n"
    "  \"opaque\": [{ \"shape\": \"box\", \"name\": \"wall\", \"min\": [0, 1, 2], \"max\": [3, 4, 5], \"color\": [0.1, 0.2, "
    "0.3] },\n"
    "    { \"shape\": \"plane\", \"point\": [0, -1, 0], \"normal\": [0, 3, 0] },\n"
    "    { \"shape\": \"sphere\", \"center\": [6, 7, 8], \"radius\": 2 }] }\n";

static bool parse(const char *text, demo_scene *scene, char message[256])
{
    return scene_parse(text, strlen(text), "scene.json", scene, message, 256);
}

static void check_numbers(const double *actual, const double *expected, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        check_close(actual[i], expected[i], 0);
}

static void check_settings(const demo_scene *s)
{
    check_numbers(s->camera.eye, (double[]){1, 2, 8}, 3);
    check_numbers(s->camera.target, (double[]){0.5, 0, 0}, 3);
    check_numbers(s->camera.up, (double[]){0, 0, 1}, 3);
    assert_false(s->camera.orthographic);
    check_close(s->camera.fov_y_degrees, 60, 0);
    check_close(s->camera.near_depth, 0.5, 0);
    check_close(s->camera.far_depth, 50, 0);
    check_close(s->interval_start, 3, 0);
    check_close(s->interval_end, 15, 0);
    check_close(s->decay_alpha, 2, 0);
    check_close(s->decay_beta, 0.5, 0);
    check_close(s->core_pixels, 2, 0);
    check_close(s->exposure, 3, 0);
    check_close(s->light_gain, 20, 0);
    check_close(s->light_reach, 8, 0);
    check_close(s->shadow_thickness, 0.5, 0);
    check_close(s->fog.extinction, 0.3, 0);
    check_close(s->fog.base, -1, 0);
    check_close(s->fog.scale, 4, 0);
    check_numbers(s->fog.up, (double[]){0, 0, 2}, 3);
    check_close(s->sources.epsilon, 0.01, 0);
    check_numbers(s->background, (double[]){0.1, 0.2, 0.3}, 3);
    assert_int_equal(s->composite, EW_OUTPUT_ADD);
}

static void check_media(const demo_scene *s)
{
    assert_int_equal(s->medium_count, 3);
    const ew_medium *box = &s->media[0], *sphere = &s->media[1], *ellipsoid = &s->media[2];
    assert_int_equal(box->shape, EW_MEDIUM_BOX);
    check_numbers(box->center, (double[]){1.5, 3, 5}, 3);
    check_numbers(box->half_axes[0], (double[]){1.5, 0, 0, 0, 2, 0, 0, 0, 3}, 9);
    check_close(box->extinction, 0.5, 0);
    check_close(box->albedo, 0, 0);
    check_numbers(box->ambient, (double[]){1, 1, 1}, 3);
    assert_int_equal(sphere->shape, EW_MEDIUM_ELLIPSOID);
    check_numbers(sphere->center, (double[]){1, 2, 3}, 3);
    check_numbers(sphere->half_axes[0], (double[]){4, 0, 0, 0, 4, 0, 0, 0, 4}, 9);
    check_close(sphere->albedo, 0.25, 0);
    check_numbers(sphere->ambient, (double[]){7, 8, 9}, 3);
    assert_int_equal(ellipsoid->shape, EW_MEDIUM_ELLIPSOID);
    check_numbers(ellipsoid->half_axes[0], (double[]){0, 4, 0, 0, 0, -5, 6, 0, 0}, 9);
}

static void check_sources(const demo_scene *s)
{
    assert_int_equal(s->sources.point_count, 1);
    check_numbers(s->sources.points[0].position, (double[]){100000.0000001, 2, 3}, 3);
    check_close(s->sources.points[0].coefficient, 4, 0);
    check_numbers(s->sources.points[0].color, (double[]){5, 6, 7}, 3);

    assert_int_equal(s->sources.line_count, 1);
    check_numbers(s->sources.lines[0].position, (double[]){1, 2, 3}, 3);
    check_numbers(s->sources.lines[0].direction, (double[]){0, 0, 5}, 3);
    check_close(s->sources.lines[0].coefficient, 1, 0);
    check_close(s->sources.lines[0].core, 0.02, 0);
    check_numbers(s->sources.lines[0].color, (double[]){0.4, 0.5, 0.6}, 3);

    assert_int_equal(s->sources.torus_count, 1);
    check_numbers(s->sources.tori[0].center, (double[]){1, 2, 3}, 3);
    check_numbers(s->sources.tori[0].axis, (double[]){0, 2, 0}, 3);
    check_close(s->sources.tori[0].radius, 0.9, 0);
    check_close(s->sources.tori[0].coefficient, 5.1, 0);

    assert_int_equal(s->sources.curve_count, 2);
    const ew_curve *bezier = &s->sources.curves[0], *parabola = &s->sources.curves[1];
    check_numbers(&bezier->polynomial[0][0], (double[]){0, 0, 0, 2, 4, 0, 0, -4, 0}, 9);
    check_numbers(bezier->domain, (double[]){0, 1}, 2);
    assert_int_equal(bezier->weight_count, 3);
    check_numbers(bezier->weights, (double[]){1, 0.2, 0.6}, 3);
    check_numbers(&parabola->polynomial[0][0], (double[]){1, 2, 3, 4, 5, 6, 7, 8, 9}, 9);
    check_numbers(parabola->domain, (double[]){-2, 2}, 2);
    assert_null(parabola->weights);
    assert_int_equal(parabola->weight_count, 0);
}

static void check_paths(const demo_scene *s)
{
    assert_int_equal(s->sources.path_count, 2);
    const ew_path *beam = &s->sources.paths[0], *loop = &s->sources.paths[1];
    assert_int_equal(beam->kind, EW_PATH_POLYLINE);
    assert_int_equal(beam->is_closed, 0);
    assert_int_equal(beam->point_count, 2);
    check_numbers(&beam->points[0][0], (double[]){1, 2, 3, 4, 5, 6}, 6);
    check_close(beam->core, 0.05, 0);
    check_close(beam->reach, 1.5, 0);
    check_close(beam->brightness, 0.8, 0);
    check_close(beam->coefficient, 0, 0);
    check_close(beam->sharpness, 2, 0);
    check_numbers(beam->color, (double[]){1, 2, 3}, 3);
    assert_null(beam->weights);

    assert_int_equal(loop->kind, EW_PATH_CATMULL_ROM);
    assert_int_equal(loop->is_closed, 1);
    assert_int_equal(loop->point_count, 3);
    assert_int_equal(loop->weight_count, 2);
    check_numbers(loop->weights, (double[]){1, 2}, 2);
    check_close(loop->coefficient, 1, 0);
    check_close(loop->core, 0, 0);
    check_close(loop->reach, 0, 0);
}

static void check_opaque_shapes(const demo_scene *s)
{
    assert_int_equal(s->opaque_count, 3);
    assert_int_equal(s->opaque[0].kind, OPAQUE_BOX);
    check_numbers(s->opaque[0].shape.box.min, (double[]){0, 1, 2}, 3);
    check_numbers(s->opaque[0].shape.box.max, (double[]){3, 4, 5}, 3);
    check_numbers(s->opaque[0].color, (double[]){0.1, 0.2, 0.3}, 3);
    assert_int_equal(s->opaque[1].kind, OPAQUE_PLANE);
    check_numbers(s->opaque[1].shape.plane.point, (double[]){0, -1, 0}, 3);
    check_numbers(s->opaque[1].shape.plane.normal, (double[]){0, 3, 0}, 3);
    assert_int_equal(s->opaque[2].kind, OPAQUE_SPHERE);
    check_numbers(s->opaque[2].shape.sphere.center, (double[]){6, 7, 8}, 3);
    check_close(s->opaque[2].shape.sphere.radius, 2, 0);
}

static void check_full_scene(const demo_scene *s)
{
    check_settings(s);
    check_media(s);
    check_sources(s);
    check_paths(s);
    check_opaque_shapes(s);
}

static void everything_in_the_file_arrives(void **state)
{
    (void)state;
    demo_scene s;
    char message[256] = "";
    if (!parse(full_scene, &s, message)) fail_msg("%s", message);
    check_full_scene(&s);
    scene_free(&s);
}

/* Reads a scene, writes it, and reads what was written. */
static void rewrite(const char *text, demo_scene *again)
{
    demo_scene s;
    char message[256] = "";
    if (!parse(text, &s, message)) fail_msg("%s", message);
    char *written = scene_write(&s);
    assert_non_null(written);
    scene_free(&s);
    if (!parse(written, again, message)) fail_msg("%s in:\n%s", message, written);
    free(written);
}

static void what_is_written_is_the_same_scene(void **state)
{
    (void)state;
    demo_scene s;
    rewrite(full_scene, &s);
    check_full_scene(&s);
    scene_free(&s);

    rewrite("{ \"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0], \"projection\": \"orthographic\", \"height\": 3.5 },"
            " \"points\": [{ \"position\": [0, 0, 0], \"reach\": 2, \"brightness\": 0 }], \"composite\": \"soft\" }",
            &s);
    assert_true(scene_is_world(&s));
    assert_true(s.camera.orthographic);
    check_close(s.camera.height, 3.5, 0);
    check_close(s.sources.points[0].coefficient, 0, 0);
    check_close(s.sources.points[0].reach, 2, 0);
    assert_int_equal(s.composite, EW_OUTPUT_SOFT);
    scene_free(&s);
}

static void what_the_file_leaves_out_has_its_default(void **state)
{
    (void)state;
    demo_scene s;
    char message[256] = "";
    if (!parse("{ " CAMERA " }", &s, message)) fail_msg("%s", message);
    check_numbers(s.camera.up, (double[]){0, 1, 0}, 3);
    check_close(s.camera.fov_y_degrees, 45, 0);
    check_close(s.interval_start, 0, 0);
    check_close(s.interval_end, 0, 0);
    check_close(s.core_pixels, 1.5, 0);
    check_close(s.exposure, 1, 0);
    check_close(s.light_reach, 0, 0);
    check_close(s.fog.extinction, 0, 0);
    check_close(s.decay_alpha, 1, 0);
    check_close(s.decay_beta, 1, 0);
    check_close(s.sources.epsilon, 0.001, 0);
    check_numbers(s.background, (double[]){0, 0, 0}, 3);
    check_numbers(s.color, (double[]){0.2, 0.5, 1}, 3);
    assert_int_equal(s.composite, EW_OUTPUT_LERP);
    assert_int_equal(
        s.sources.point_count + s.sources.line_count + s.sources.torus_count + s.sources.curve_count + s.sources.path_count, 0);
    assert_int_equal(s.opaque_count, 0);
    scene_free(&s);
}

static void an_interval_asks_for_the_papers_integral(void **state)
{
    (void)state;
    demo_scene s;
    char message[256] = "";
    if (!parse(WORLD("\"interval\": {}"), &s, message)) fail_msg("%s", message);
    assert_false(scene_is_world(&s));
    check_close(s.interval_start, 0.1, 0);
    check_close(s.interval_end, 100, 0);
    check_close(s.core_pixels, 0, 0);
    scene_free(&s);
}

/* The library knows these defaults as 0, but for the coefficient. */
static void what_a_source_leaves_out_has_its_default(void **state)
{
    (void)state;
    demo_scene s;
    char message[256] = "";
    if (!parse(WORLD("\"points\": [{ \"position\": [0, 0, 0], \"reach\": 1 }]"), &s, message)) fail_msg("%s", message);
    const ew_point *point = &s.sources.points[0];
    check_close(point->coefficient, 1, 0);
    check_close(point->brightness, 0, 0);
    check_close(point->core, 0, 0);
    check_close(point->reach, 1, 0);
    check_close(point->sharpness, 0, 0);
    check_numbers(point->color, s.color, 3);
    scene_free(&s);
}

static void every_kind_of_source_takes_all_of_the_light(void **state)
{
    (void)state;
#define LIGHT ", \"core\": 0.1, \"reach\": 2, \"brightness\": 0.5, \"sharpness\": 3"
    demo_scene s;
    char message[256] = "";
    const char *text = WORLD("\"points\": [{ \"position\": [0, 0, 0]" LIGHT "}],"
                             "\"lines\": [{ \"position\": [0, 0, 0], \"direction\": [0, 0, 1]" LIGHT "}],"
                             "\"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 0, 1], \"radius\": 1" LIGHT "}],"
                             "\"curves\": [{ " ARC LIGHT "}],"
                             "\"paths\": [{ \"points\": [[0, 0, 0], [1, 0, 0]]" LIGHT "}]");
    if (!parse(text, &s, message)) fail_msg("%s", message);
    const ew_sources_desc *d = &s.sources;
    const double expected[] = {0.1, 2, 0.5, 3};
#define CHECK(source) check_numbers((double[]){source.core, source.reach, source.brightness, source.sharpness}, expected, 4)
    CHECK(d->points[0]);
    CHECK(d->lines[0]);
    CHECK(d->tori[0]);
    CHECK(d->curves[0]);
    CHECK(d->paths[0]);
#undef CHECK
#undef LIGHT
    scene_free(&s);
}

static void every_kind_of_path_and_composite_is_known_by_its_name(void **state)
{
    (void)state;
    static const char *const kinds[] = {[EW_PATH_POLYLINE] = "polyline",
                                        [EW_PATH_BSPLINE] = "bspline",
                                        [EW_PATH_BEZIER] = "bezier",
                                        [EW_PATH_CATMULL_ROM] = "catmull_rom"};
    const struct {
        const char *name;
        ew_output output;
    } composites[] = {{"lerp", EW_OUTPUT_LERP}, {"add", EW_OUTPUT_ADD}, {"soft", EW_OUTPUT_SOFT}};
    demo_scene s;
    char message[256] = "", text[400];
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i) {
        snprintf(text, sizeof text,
                 PAPER("\"paths\": [{ \"kind\": \"%s\", \"points\": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [2, 1, 0]] }]"),
                 kinds[i]);
        if (!parse(text, &s, message)) fail_msg("%s", message);
        assert_int_equal(s.sources.paths[0].kind, i);
        scene_free(&s);
    }
    for (size_t i = 0; i < sizeof composites / sizeof *composites; ++i) {
        snprintf(text, sizeof text, WORLD("\"composite\": \"%s\""), composites[i].name);
        if (!parse(text, &s, message)) fail_msg("%s", message);
        assert_int_equal(s.composite, composites[i].output);
        scene_free(&s);
    }
}

static void a_byte_order_mark_is_skipped_and_utf16_is_named(void **state)
{
    (void)state;
    demo_scene s;
    char message[256] = "";
    if (!parse("\xef\xbb\xbf{ " CAMERA " }", &s, message)) fail_msg("%s", message);
    scene_free(&s);
    static const char *const texts[] = {"\xff\xfe{\0 \0}\0", "\xfe\xff\0{\0 \0}", "{\0 \0}\0", "\0{\0 \0}"};
    static const size_t lengths[] = {8, 8, 6, 6};
    for (int i = 0; i < 4; ++i) {
        assert_false(scene_parse(texts[i], lengths[i], "scene.json", &s, message, sizeof message));
        if (!strstr(message, "scene.json: is UTF-16")) fail_msg("%s", message);
    }
}

/* Text that is refused with a message that begins with the file's name and the place. */
typedef struct scene_fault {
    const char *text;
    const char *place;
} scene_fault;

static void check_faults(const scene_fault *faults, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        demo_scene s;
        char message[256] = "", expected[64];
        snprintf(expected, sizeof expected, "scene.json: %s", faults[i].place);
        if (parse(faults[i].text, &s, message)) fail_msg("taken: %s", faults[i].text);
        if (strncmp(message, expected, strlen(expected)) != 0 || strchr(message, '\n'))
            fail_msg("\"%s\" expected for %s: %s", expected, faults[i].text, message);
    }
}

static void a_fault_is_named_with_its_place(void **state)
{
    (void)state;
    static const scene_fault faults[] = {
        {"", "line 1, column "},
        {"{\n  \"camera\": { \"eye\" [0, 0, 8] } }", "line 2, column "},
        {"{ \"epsilon\": NaN }", "line 1, column "},
        {"{ \"epsilon\": 1e999 }", "line 1, column "},
        {"{} {}", "line 1, column "},
        {"{ " CAMERA ", " CAMERA " }", "line 1, column "},
        {"{}", "camera: "},
        {"{ \"camera\": [0, 0, 8] }", "camera: "},
        {"{ \"camera\": { \"target\": [0, 0, 0] } }", "camera.eye: "},
        {"{ \"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 8] } }", "camera.target: "},
        {"{ \"camera\": { \"eye\": [0, 8, 0], \"target\": [0, 0, 0] } }", "camera.up: "},
        {"{ \"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0], \"fov\": 45 } }", "camera.fov: "},
        {"{ \"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0], \"near\": 0 } }", "camera.near: "},
        {"{ \"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0], \"far\": 0.1 } }", "camera.far: "},
        {"{ " CAMERA ", " INTERVAL ", \"points\": 1 }", "points: "},
        {"{ " CAMERA ", " INTERVAL ", \"points\": [{ \"position\": [0, 0, 0] }, { \"position\": [0, \"1\", 0] }] }",
         "points[1].position[1]: "},
        {"{ " CAMERA ", " INTERVAL ", \"lines\": [{ \"position\": [0, 0, 0], \"direction\": [0, 0, 0] }] }",
         "lines[0].direction: "},
        {"{ " CAMERA ", " INTERVAL ", \"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 0, 0], \"radius\": 1 }] }",
         "tori[0].axis: "},
        {"{ " CAMERA ", " INTERVAL ", \"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 1, 0], \"radius\": -1 }] }",
         "tori[0].radius: "},
        {"{ " CAMERA ", " INTERVAL ", \"curves\": [{ " ARC ", \"domain\": [1, 1] }] }", "curves[0].domain: "},
        {"{ " CAMERA ", " INTERVAL ", \"curves\": [{ " ARC ", \"weights\": [] }] }", "curves[0].weights: "},
        {"{ " CAMERA ", " INTERVAL ", \"curves\": [{ " ARC " }, { " ARC ", \"weights\": [1, null] }] }",
         "curves[1].weights[1]: "},
        {"{ " CAMERA ", \"interval\": { \"start\": 3, \"end\": 3 } }", "interval.end: "},
        {"{ " CAMERA ", " INTERVAL ", \"decay\": { \"beta\": 0 } }", "decay.beta: "},
        {"{ " CAMERA ", \"epsilon\": 0 }", "epsilon: "},
        {"{ " CAMERA ", \"composite\": \"over\" }", "composite: "},
        {"{ " CAMERA ", \"opaque\": [{ \"shape\": \"torus\" }] }", "opaque[0].shape: "},
        {"{ " CAMERA ", \"colour\": [1, 1, 1] }", "colour: "},
        {WORLD("\"decay\": {}"), "decay: "},
        {WORLD("\"core_pixels\": 65"), "core_pixels: "},
        {WORLD("\"core_pixels\": -1"), "core_pixels: "},
        {WORLD("\"exposure\": 2e6"), "exposure: "},
        {WORLD("\"exposure\": -1"), "exposure: "},
        {WORLD("\"light\": {}"), "light.reach: "},
        {WORLD("\"light\": { \"reach\": 0 }"), "light.reach: "},
        {WORLD("\"light\": { \"reach\": 1, \"gain\": 2e6 }"), "light.gain: "},
        {WORLD("\"light\": { \"reach\": 1, \"shadow_thickness\": -1 }"), "light.shadow_thickness: "},
        {WORLD("\"fog\": 0.1"), "fog: "},
        {WORLD("\"fog\": {}"), "fog.extinction: "},
        {WORLD("\"fog\": { \"extinction\": -0.1 }"), "fog.extinction: "},
        {WORLD("\"fog\": { \"extinction\": 2e12 }"), "fog.extinction: "},
        {WORLD("\"fog\": { \"extinction\": 1, \"density\": 1 }"), "fog.density: "},
        {WORLD("\"fog\": { \"extinction\": 1, \"height\": 5 }"), "fog.height: "},
        {WORLD("\"fog\": { \"extinction\": 1, \"height\": {} }"), "fog.height.scale: "},
        {WORLD("\"fog\": { \"extinction\": 1, \"height\": { \"scale\": 0 } }"), "fog.height.scale: "},
        {WORLD("\"fog\": { \"extinction\": 1, \"height\": { \"scale\": 1, \"up\": [0, 0, 0] } }"), "fog.height.up: "},
        {"[]", "must be a JSON object"},
    };
    check_faults(faults, sizeof faults / sizeof *faults);
}

static void a_fault_of_a_medium_is_named_with_its_place(void **state)
{
    (void)state;
    static const scene_fault faults[] = {
        {WORLD("\"media\": {}"), "media: "},
        {WORLD("\"media\": [{ \"shape\": \"plane\" }]"), "media[0].shape: "},
        {WORLD("\"media\": [{ \"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1 }]"), "media[0].extinction: "},
        {WORLD("\"media\": [{ " BALL ", \"radius\": 0, \"extinction\": 1 }]"), "media[0].radius: "},
        {WORLD("\"media\": [{ " BALL ", \"radius\": 1, \"extinction\": -1 }]"), "media[0].extinction: "},
        {WORLD("\"media\": [{ " BALL ", \"radius\": 1, \"extinction\": 2e12 }]"), "media[0].extinction: "},
        {WORLD("\"media\": [{ " BALL ", \"radius\": 1, \"extinction\": 1, \"albedo\": 1.5 }]"), "media[0].albedo: "},
        {WORLD("\"media\": [{ " BALL ", \"radius\": 1, \"extinction\": 1, \"ambient\": [1, -1, 1] }]"), "media[0].ambient"},
        {WORLD("\"media\": [{ " BALL ", \"radius\": 1, \"extinction\": 1, \"color\": [1, 1, 1] }]"), "media[0].color: "},
        {WORLD("\"media\": [{ " BLOCK ", \"max\": [1, 0, 1], \"extinction\": 1 }]"), "media[0].max: "},
        {WORLD("\"media\": [{ " EGG ", \"radii\": [1, 0, 1], \"extinction\": 1 }]"), "media[0].radii"},
        {WORLD("\"media\": [{ " EGG
               ", \"radii\": [1, 1, 1], \"axes\": [[1, 0, 0], [0, 1, 0], [1, 1, 0]], \"extinction\": 1 }]"),
         "media[0].axes: "},
        {WORLD("\"media\": [{ " EGG
               ", \"radii\": [1, 1, 1], \"axes\": [[1, 0, 0], [0, 0, 0], [0, 0, 1]], \"extinction\": 1 }]"),
         "media[0].axes: "},
    };
    check_faults(faults, sizeof faults / sizeof *faults);
}

static void a_fault_of_a_sources_light_is_named_with_its_place(void **state)
{
    (void)state;
    static const scene_fault faults[] = {
        {WORLD("\"points\": [{ \"position\": [0, 0, 0] }]"), "points[0].reach: "},
        {WORLD("\"lines\": [{ \"position\": [0, 0, 0], \"direction\": [0, 0, 1] }]"), "lines[0].reach: "},
        {WORLD("\"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 1, 0], \"radius\": 1 }]"), "tori[0].reach: "},
        {WORLD("\"curves\": [{ " ARC ", \"reach\": 1 }, { " ARC " }]"), "curves[1].reach: "},
        {WORLD("\"paths\": [{ " BEAM ", \"brightness\": 1 }]"), "paths[0].reach: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": 1, \"core\": 1 }]"), "paths[0].reach: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": 0.001 }]"), "paths[0].reach: "},
        {WORLD("\"epsilon\": 2, \"paths\": [{ " BEAM ", \"reach\": 1 }]"), "paths[0].reach: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": -1 }]"), "paths[0].reach: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": 1, \"core\": 0 }]"), "paths[0].core: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": 1, \"sharpness\": 0.5 }]"), "paths[0].sharpness: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": 1, \"brightness\": 1, \"coefficient\": 1 }]"), "paths[0].brightness: "},
        {WORLD("\"paths\": [{ " BEAM ", \"reach\": 1, \"brightness\": -1 }]"), "paths[0].brightness: "},
        {PAPER("\"points\": [{ \"position\": [0, 0, 0], \"brightness\": 1 }]"), "points[0].brightness: "},
        {PAPER("\"points\": [{ \"position\": [0, 0, 0], \"sharpness\": 2 }]"), "points[0].sharpness: "},
    };
    check_faults(faults, sizeof faults / sizeof *faults);
}

static void a_fault_of_a_path_is_named_with_its_place(void **state)
{
    (void)state;
    static const scene_fault faults[] = {
        {PAPER("\"paths\": [{}]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ \"points\": [] }]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ \"points\": [[0, 0, 0]] }]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ \"points\": [[0, 0, 0], [1, 0]] }]"), "paths[0].points[1]: "},
        {PAPER("\"paths\": [{ \"points\": [[0, 0, 0], [1, 0, null]] }]"), "paths[0].points[1][2]: "},
        {PAPER("\"paths\": [{ " BEAM ", \"kind\": \"spiral\" }]"), "paths[0].kind: "},
        {PAPER("\"paths\": [{ " BEAM ", \"kind\": \"bspline\" }]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ " BEAM ", \"kind\": \"bezier\" }]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ \"kind\": \"bezier\", \"points\": [[0, 0, 0]] }]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ \"kind\": \"bezier\", \"points\": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 2, 0]] }]"),
         "paths[0].points: "},
        {PAPER("\"paths\": [{ \"kind\": \"bezier\", \"closed\": true,"
               " \"points\": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }]"),
         "paths[0].closed: "},
        {PAPER("\"paths\": [{ " BEAM ", \"closed\": true }]"), "paths[0].points: "},
        {PAPER("\"paths\": [{ " BEAM ", \"closed\": 1 }]"), "paths[0].closed: "},
        {PAPER("\"paths\": [{ " BEAM ", \"weights\": [] }]"), "paths[0].weights: "},
        {PAPER("\"paths\": [{ " BEAM ", \"weights\": [1, -1] }]"), "paths[0].weights[1]: "},
        {PAPER("\"paths\": [{ " BEAM ", \"radius\": 1 }]"), "paths[0].radius: "},
    };
    check_faults(faults, sizeof faults / sizeof *faults);
}

/* The text of a scene with one path that has this many points and weights. The caller frees it. */
static char *long_path(int points, int weights)
{
    char *text = malloc((size_t)(points + weights) * 12 + 200);
    assert_non_null(text);
    char *end = text + sprintf(text, "{ " CAMERA ", " INTERVAL ", \"paths\": [{ \"points\": [[0, 0, 0]");
    for (int i = 1; i < points; ++i)
        end += sprintf(end, ", [%d, 0, 0]", i % 10);
    end += sprintf(end, "], \"weights\": [1");
    for (int i = 1; i < weights; ++i)
        end += sprintf(end, ", 1");
    sprintf(end, "] }] }");
    return text;
}

static void a_path_has_a_largest_count_of_points_and_weights(void **state)
{
    (void)state;
    const struct {
        int points, weights;
        const char *place; /* NULL: taken */
    } cases[] = {{4096, 1024, NULL}, {4097, 1, "paths[0].points: "}, {2, 1025, "paths[0].weights: "}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char *text = long_path(cases[i].points, cases[i].weights), message[256] = "";
        demo_scene s;
        bool taken = parse(text, &s, message);
        if (taken != !cases[i].place || (!taken && !strstr(message, cases[i].place))) fail_msg("case %zu: %s", i, message);
        if (taken) scene_free(&s);
        free(text);
    }
}

/* A file that was cut off anywhere is refused; the text is as long as is said, with no zero behind it. */
static void every_part_of_a_scene_is_refused(void **state)
{
    (void)state;
    size_t length = strlen(full_scene) - 2; /* without the last brace and newline */
    for (size_t i = 0; i <= length; ++i) {
        char *part = malloc(i > 0 ? i : 1);
        assert_non_null(part);
        memcpy(part, full_scene, i);
        demo_scene s;
        char message[256] = "";
        if (scene_parse(part, i, "scene.json", &s, message, sizeof message)) fail_msg("the first %zu bytes are taken", i);
        assert_true(strncmp(message, "scene.json: ", 12) == 0 && !strchr(message, '\n'));
        free(part);
    }
}

static void hostile_text_is_refused_in_one_line(void **state)
{
    (void)state;
    enum { DEPTH = 100000 };
    char *deep = malloc(DEPTH + 1);
    assert_non_null(deep);
    memset(deep, '[', DEPTH);
    deep[DEPTH] = '\0';
    const struct {
        const char *text;
        size_t length;
    } cases[] = {
        {deep, DEPTH},     {"{ \"a\0b\": 1 }", 13},     {"{ \"a\\u0000b\": 1 }", 17}, {"{ \"a\\nb\": 1 }", 13},
        {"\xff\xfe{}", 4}, {"{ \"\xc3\x28\": 1 }", 11},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        demo_scene s;
        char message[256] = "";
        assert_false(scene_parse(cases[i].text, cases[i].length, "scene.json", &s, message, sizeof message));
        assert_true(strlen(message) > 0 && !strchr(message, '\n'));
    }
    free(deep);
}

static void a_message_never_overflows_its_buffer(void **state)
{
    (void)state;
    for (size_t size = 1; size < 40; ++size) {
        char message[64];
        memset(message, '#', sizeof message);
        demo_scene s;
        assert_false(scene_parse("{}", 2, "scene.json", &s, message, size));
        assert_true(memchr(message, '\0', size) != NULL);
        for (size_t i = size; i < sizeof message; ++i)
            assert_int_equal(message[i], '#');
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_in_the_file_arrives),
        cmocka_unit_test(what_is_written_is_the_same_scene),
        cmocka_unit_test(what_the_file_leaves_out_has_its_default),
        cmocka_unit_test(an_interval_asks_for_the_papers_integral),
        cmocka_unit_test(what_a_source_leaves_out_has_its_default),
        cmocka_unit_test(every_kind_of_source_takes_all_of_the_light),
        cmocka_unit_test(every_kind_of_path_and_composite_is_known_by_its_name),
        cmocka_unit_test(a_byte_order_mark_is_skipped_and_utf16_is_named),
        cmocka_unit_test(a_fault_is_named_with_its_place),
        cmocka_unit_test(a_fault_of_a_medium_is_named_with_its_place),
        cmocka_unit_test(a_fault_of_a_sources_light_is_named_with_its_place),
        cmocka_unit_test(a_fault_of_a_path_is_named_with_its_place),
        cmocka_unit_test(a_path_has_a_largest_count_of_points_and_weights),
        cmocka_unit_test(every_part_of_a_scene_is_refused),
        cmocka_unit_test(hostile_text_is_refused_in_one_line),
        cmocka_unit_test(a_message_never_overflows_its_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
