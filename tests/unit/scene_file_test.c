/* The scene file: what it says arrives, and what is wrong with it is named with its place. */
#include "check.h"
#include "scene_file.h"

#include <stdio.h>
#include <stdlib.h>

#define CAMERA "\"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0] }"

static const char full_scene[] =
    "{ \"version\": 1, \"comment\": \"everything\",\n"
    "  \"camera\": { \"eye\": [1, 2, 8], \"target\": [0.5, 0, 0], \"up\": [0, 0, 1], \"fov_y_degrees\": 60,"
    " \"near\": 0.5, \"far\": 50 },\n"
    "  \"interval\": { \"start\": 3, \"end\": 15 }, \"decay\": { \"alpha\": 2, \"beta\": 0.5 }, \"epsilon\": 0.01,\n"
    "  \"background\": [0.1, 0.2, 0.3], \"color\": [0.4, 0.5, 0.6], \"composite\": \"add\",\n"
    "  \"points\": [{ \"position\": [100000.0000001, 2, 3], \"coefficient\": 4, \"color\": [5, 6, 7] }],\n"
    "  \"lines\": [{ \"position\": [1, 2, 3], \"direction\": [0, 0, 5] }],\n"
    "  \"tori\": [{ \"center\": [1, 2, 3], \"axis\": [0, 2, 0], \"radius\": 0.9, \"coefficient\": 5.1 }],\n"
    "  \"curves\": [{ \"control_points\": [[0, 0, 0], [1, 2, 0], [2, 0, 0]], \"weights\": [1, 0.2, 0.6] },\n"
    "    { \"polynomial\": [[1, 2, 3], [4, 5, 6], [7, 8, 9]], \"domain\": [-2, 2] }],\n"
    "  \"opaque\": [{ \"shape\": \"box\", \"min\": [0, 1, 2], \"max\": [3, 4, 5], \"color\": [0.1, 0.2, 0.3] },\n"
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
    check_close(s->sources.epsilon, 0.01, 0);
    check_numbers(s->background, (double[]){0.1, 0.2, 0.3}, 3);
    assert_int_equal(s->composite, EW_OUTPUT_ADD);
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

static void everything_in_the_file_arrives(void **state)
{
    (void)state;
    demo_scene s;
    char message[256] = "";
    if (!parse(full_scene, &s, message)) fail_msg("%s", message);
    check_settings(&s);
    check_sources(&s);
    check_opaque_shapes(&s);
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
    check_close(s.interval_start, 0.1, 0);
    check_close(s.interval_end, 100, 0);
    check_close(s.decay_alpha, 1, 0);
    check_close(s.decay_beta, 1, 0);
    check_close(s.sources.epsilon, 0.001, 0);
    check_numbers(s.background, (double[]){0, 0, 0}, 3);
    check_numbers(s.color, (double[]){0.2, 0.5, 1}, 3);
    assert_int_equal(s.composite, EW_OUTPUT_LERP);
    assert_int_equal(s.sources.point_count + s.sources.line_count + s.sources.torus_count + s.sources.curve_count, 0);
    assert_int_equal(s.opaque_count, 0);
    scene_free(&s);
}

/* Each case is refused with a message that begins with the file's name and the place. */
static void every_fault_is_named_with_its_place(void **state)
{
    (void)state;
#define ARC "\"control_points\": [[0, 0, 0], [1, 1, 0], [2, 0, 0]]"
    const struct {
        const char *text;
        const char *place;
    } cases[] = {
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
        {"{ " CAMERA ", \"points\": 1 }", "points: "},
        {"{ " CAMERA ", \"points\": [{ \"position\": [0, 0, 0] }, { \"position\": [0, \"1\", 0] }] }",
         "points[1].position[1]: "},
        {"{ " CAMERA ", \"lines\": [{ \"position\": [0, 0, 0], \"direction\": [0, 0, 0] }] }", "lines[0].direction: "},
        {"{ " CAMERA ", \"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 0, 0], \"radius\": 1 }] }", "tori[0].axis: "},
        {"{ " CAMERA ", \"tori\": [{ \"center\": [0, 0, 0], \"axis\": [0, 1, 0], \"radius\": -1 }] }", "tori[0].radius: "},
        {"{ " CAMERA ", \"curves\": [{ " ARC ", \"domain\": [1, 1] }] }", "curves[0].domain: "},
        {"{ " CAMERA ", \"curves\": [{ " ARC ", \"weights\": [] }] }", "curves[0].weights: "},
        {"{ " CAMERA ", \"curves\": [{ " ARC " }, { " ARC ", \"weights\": [1, null] }] }", "curves[1].weights[1]: "},
        {"{ " CAMERA ", \"interval\": { \"start\": 3, \"end\": 3 } }", "interval.end: "},
        {"{ " CAMERA ", \"decay\": { \"beta\": 0 } }", "decay.beta: "},
        {"{ " CAMERA ", \"epsilon\": 0 }", "epsilon: "},
        {"{ " CAMERA ", \"composite\": \"over\" }", "composite: "},
        {"{ " CAMERA ", \"opaque\": [{ \"shape\": \"torus\" }] }", "opaque[0].shape: "},
        {"{ " CAMERA ", \"colour\": [1, 1, 1] }", "colour: "},
        {"[]", "must be a JSON object"},
    };
#undef ARC
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        demo_scene s;
        char message[256] = "", expected[64];
        snprintf(expected, sizeof expected, "scene.json: %s", cases[i].place);
        if (parse(cases[i].text, &s, message)) fail_msg("taken: %s", cases[i].text);
        if (strncmp(message, expected, strlen(expected)) != 0 || strchr(message, '\n'))
            fail_msg("\"%s\" expected for %s: %s", expected, cases[i].text, message);
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
        cmocka_unit_test(everything_in_the_file_arrives),      cmocka_unit_test(what_the_file_leaves_out_has_its_default),
        cmocka_unit_test(every_fault_is_named_with_its_place), cmocka_unit_test(every_part_of_a_scene_is_refused),
        cmocka_unit_test(hostile_text_is_refused_in_one_line), cmocka_unit_test(a_message_never_overflows_its_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
