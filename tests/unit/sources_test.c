/* Source lists: what is wrong with them is named, and what is refused changes nothing. */
#include "base/allocator.h"
#include "check.h"
#include "model/sources.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

/* What a number of a source may be. */
typedef enum range { FINITE, NOT_NEGATIVE, POSITIVE } range;

/* Two good sources of every kind; the tests spoil one number of the second at a time. */
typedef struct field {
    ew_point points[2];
    ew_line lines[2];
    ew_torus tori[2];
    ew_curve curves[2];
    ew_path paths[2];
    double path_points[2][4][3];
    double weights[4];
    ew_sources_desc desc;
} field;

static void make_field(field *f)
{
    *f = (field){.weights = {1, 0.2, 0.6, 1}};
    for (int i = 0; i < 2; ++i) {
        f->points[i] = (ew_point){.position = {1, 2, 3}, .coefficient = 1, .color = {1, 1, 1}};
        f->lines[i] = (ew_line){.position = {1, 2, 3}, .direction = {0, 0, 5}, .coefficient = 1, .color = {1, 1, 1}};
        f->tori[i] = (ew_torus){.center = {1, 2, 3}, .axis = {0, 2, 0}, .radius = 0.9, .coefficient = 5.1, .color = {1, 1, 1}};
        f->curves[i] = (ew_curve){.polynomial = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}},
                                  .domain = {-2, 2},
                                  .weights = f->weights,
                                  .weight_count = 4,
                                  .coefficient = 1,
                                  .color = {1, 1, 1}};
    }
    static const double polyline[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 3}};
    for (int i = 0; i < 2; ++i) {
        memcpy(f->path_points[i], polyline, sizeof polyline);
        f->paths[i] = (ew_path){.points = (const double(*)[3])f->path_points[i],
                                .point_count = 4,
                                .weights = f->weights,
                                .weight_count = 4,
                                .coefficient = 1,
                                .color = {1, 1, 1}};
    }
    f->desc = (ew_sources_desc){.points = f->points,
                                .point_count = 2,
                                .lines = f->lines,
                                .line_count = 2,
                                .tori = f->tori,
                                .torus_count = 2,
                                .curves = f->curves,
                                .curve_count = 2,
                                .paths = f->paths,
                                .path_count = 2,
                                .epsilon = 1e-3};
}

static ew_result create(const ew_sources_desc *sources, ew_sources *taken, ew_error *error)
{
    return ew_sources_set(taken, sources, &ew_default_allocator, error);
}

/* Expects `desc` to be refused, with an ew_error and without, and the sources that were there before to be as they were. */
static void expect_refused(const ew_sources_desc *desc, ew_result code, const char *name)
{
    field old;
    make_field(&old);
    ew_sources taken = {0}, before;
    assert_int_equal(create(&old.desc, &taken, NULL), EW_OK);
    memcpy(&before, &taken, sizeof taken);

    ew_error error = {EW_OK, ""};
    ew_result result = create(desc, &taken, &error);
    check_refused(result, &error, code, name);
    assert_int_equal(create(desc, &taken, NULL), code);
    assert_memory_equal(&taken, &before, sizeof taken);
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        const void *list;
        size_t count;
        memcpy(&list, (const char *)&old.desc + ew_kinds[kind]->list_offset, sizeof list);
        memcpy(&count, (const char *)&old.desc + ew_kinds[kind]->count_offset, sizeof count);
        if (count > 0) assert_memory_equal(taken.lists[kind], list, count * ew_kinds[kind]->size);
    }
    ew_sources_destroy(&taken, &ew_default_allocator);
}

static void every_number_out_of_range_is_refused_by_name(void **state)
{
    (void)state;
    field f;
    make_field(&f);
    const struct {
        double *number;
        const char *name;
        range allowed;
    } numbers[] = {
        {&f.desc.epsilon, "epsilon", POSITIVE},
        {&f.points[1].position[0], "points[1].position", FINITE},
        {&f.points[1].position[2], "points[1].position", FINITE},
        {&f.points[1].coefficient, "points[1].coefficient", NOT_NEGATIVE},
        {&f.points[1].color[0], "points[1].color", NOT_NEGATIVE},
        {&f.points[1].color[2], "points[1].color", NOT_NEGATIVE},
        {&f.lines[1].position[1], "lines[1].position", FINITE},
        {&f.lines[1].direction[0], "lines[1].direction", FINITE},
        {&f.lines[1].coefficient, "lines[1].coefficient", NOT_NEGATIVE},
        {&f.lines[1].color[1], "lines[1].color", NOT_NEGATIVE},
        {&f.tori[1].center[2], "tori[1].center", FINITE},
        {&f.tori[1].axis[1], "tori[1].axis", FINITE},
        {&f.tori[1].radius, "tori[1].radius", NOT_NEGATIVE},
        {&f.tori[1].coefficient, "tori[1].coefficient", NOT_NEGATIVE},
        {&f.tori[1].color[2], "tori[1].color", NOT_NEGATIVE},
        {&f.curves[1].polynomial[0][0], "curves[1].polynomial", FINITE},
        {&f.curves[1].polynomial[1][1], "curves[1].polynomial", FINITE},
        {&f.curves[1].polynomial[2][2], "curves[1].polynomial", FINITE},
        {&f.curves[1].domain[0], "curves[1].domain", FINITE},
        {&f.curves[1].domain[1], "curves[1].domain", FINITE},
        {&f.curves[1].coefficient, "curves[1].coefficient", NOT_NEGATIVE},
        {&f.curves[1].color[0], "curves[1].color", NOT_NEGATIVE},
        {&f.paths[1].coefficient, "paths[1].coefficient", NOT_NEGATIVE},
        {&f.paths[1].color[2], "paths[1].color", NOT_NEGATIVE},
        {&f.path_points[1][3][1], "paths[1].points[3]", FINITE},
        {&f.points[1].brightness, "points[1].brightness", NOT_NEGATIVE},
        {&f.lines[1].core, "lines[1].core", NOT_NEGATIVE},
        {&f.tori[1].reach, "tori[1].reach", NOT_NEGATIVE},
        {&f.curves[1].brightness, "curves[1].brightness", NOT_NEGATIVE},
        {&f.curves[1].sharpness, "curves[1].sharpness", NOT_NEGATIVE},
        {&f.paths[1].core, "paths[1].core", NOT_NEGATIVE},
        {&f.paths[1].reach, "paths[1].reach", NOT_NEGATIVE},
    };
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, -1, -DBL_MIN, 0};
    const size_t bad_count[] = {[FINITE] = 3, [NOT_NEGATIVE] = 5, [POSITIVE] = 6};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
        double good = *numbers[i].number;
        for (size_t j = 0; j < bad_count[numbers[i].allowed]; ++j) {
            *numbers[i].number = bad[j];
            expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, numbers[i].name);
        }
        *numbers[i].number = good;
    }
    /* Each number was put back, so that it was the one spoilt that was refused. */
    ew_sources taken = {0};
    assert_int_equal(create(&f.desc, &taken, NULL), EW_OK);
    ew_sources_destroy(&taken, &ew_default_allocator);
}

static void every_bad_weight_is_refused_by_name(void **state)
{
    (void)state;
    field f;
    make_field(&f);
    double weights[] = {1, 1, 1};
    f.curves[1].weights = weights;
    f.curves[1].weight_count = 3;
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, -1};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        weights[2] = bad[i];
        expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "curves[1].weights[2]");
    }
}

static void directions_of_no_length_are_refused(void **state)
{
    (void)state;
    field f;
    make_field(&f);
    f.lines[1].direction[2] = 0;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "lines[1].direction");
    make_field(&f);
    f.tori[1].axis[1] = -0.0;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "tori[1].axis");
}

static void domains_of_no_length_are_refused(void **state)
{
    (void)state;
    const double domains[][2] = {{1, 1}, {1, -1}, {-DBL_MAX, DBL_MAX}};
    for (size_t i = 0; i < sizeof domains / sizeof domains[0]; ++i) {
        field f;
        make_field(&f);
        memcpy(f.curves[1].domain, domains[i], sizeof domains[i]);
        expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "curves[1].domain");
    }
}

static void lists_and_counts_that_disagree_are_refused(void **state)
{
    (void)state;
    field f;
    expect_refused(NULL, EW_ERROR_INVALID_ARGUMENT, "sources");
    make_field(&f);
    f.desc.points = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "points");
    make_field(&f);
    f.desc.lines = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "lines");
    make_field(&f);
    f.desc.tori = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "tori");
    make_field(&f);
    f.desc.curves = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "curves");
    make_field(&f);
    f.desc.paths = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "paths");
    make_field(&f);
    f.paths[1].points = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "paths[1].points");
    make_field(&f);
    f.paths[1].weights = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "paths[1].weights");
    make_field(&f);
    f.paths[1].weight_count = 0;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "paths[1].weights");
    make_field(&f);
    f.curves[1].weights = NULL;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "curves[1].weights");
    make_field(&f);
    f.curves[1].weight_count = 0;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "curves[1].weights");
    make_field(&f);
    f.curves[1].weight_count = EW_MAX_WEIGHTS + 1;
    expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "curves[1].weight_count");
}

/* Adds points to a field of two, so that `units` of an effect's are left for the field itself. */
static void leave_units(field *f, ew_point *points, size_t units, size_t units_of_point)
{
    size_t count = (EW_MAX_SOURCE_UNITS - units) / units_of_point;
    assert_int_equal(EW_MAX_SOURCE_UNITS - count * units_of_point, units);
    for (size_t i = 0; i < count + 2; ++i)
        points[i] = f->points[i % 2];
    f->desc.points = points;
    f->desc.point_count = count + 2;
}

static void more_sources_than_an_effect_holds_are_refused(void **state)
{
    (void)state;
    field f;
    make_field(&f);
    /* Two of each take 2 (2 + 3 + 3 + 6 + 5) units; 2 curves and 2 paths with 4 weights each make 2 pieces of weights each; and
     * 2 paths have 3 straight pieces of 2 units each: 58 together. */
    ew_error error = {EW_OK, ""};
    ew_sources taken = {0};
    ew_point *points = calloc(EW_MAX_POINTS + 2, sizeof *points);
    assert_non_null(points);
    static const struct {
        size_t units;
        const char *refused;
    } cases[] = {{2, "points"},
                 {8, "2 lines"},
                 {14, "2 tori"},
                 {26, "2 curves"},
                 {36, "2 paths"},
                 {44, "8 pieces of weights"},
                 {56, "12 units of paths' pieces"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        leave_units(&f, points, cases[i].units, 2);
        check_refused(ew_sources_set(&taken, &f.desc, &ew_default_allocator, &error), &error, EW_ERROR_TOO_MANY_SOURCES,
                      cases[i].refused);
    }
    leave_units(&f, points, 58, 2);
    assert_int_equal(ew_sources_set(&taken, &f.desc, &ew_default_allocator, &error), EW_OK);
    assert_int_equal(taken.data_size, EW_MAX_SOURCE_UNITS * sizeof(ew_vec4));

    /* A core of one source's own makes the blocks of all one unit longer. */
    make_field(&f);
    f.lines[0].core = 0.5;
    leave_units(&f, points, 67, 3);
    check_refused(ew_sources_set(&taken, &f.desc, &ew_default_allocator, &error), &error, EW_ERROR_TOO_MANY_SOURCES,
                  "units of paths' pieces");
    leave_units(&f, points, 70, 3);
    assert_int_equal(ew_sources_set(&taken, &f.desc, &ew_default_allocator, &error), EW_OK);
    assert_int_equal(taken.data_size, (EW_MAX_SOURCE_UNITS - 2) * sizeof(ew_vec4));
    ew_sources_destroy(&taken, &ew_default_allocator);
    free(points);

    make_field(&f);
    f.desc.point_count = SIZE_MAX;
    expect_refused(&f.desc, EW_ERROR_TOO_MANY_SOURCES, "points");
    make_field(&f);
    f.desc.path_count = SIZE_MAX;
    expect_refused(&f.desc, EW_ERROR_TOO_MANY_SOURCES, "paths");
}

static void uniform_blocks_are_used_up_to_64_kib(void **state)
{
    (void)state;
    const size_t sizes[] = {16384, 65536};
    for (size_t i = 0; i < 2; ++i) {
        size_t units = ew_sources_capacity(sizes[i]);
        assert_in_range(sizeof(struct ew_uniform_head) + units * sizeof(ew_vec4), sizes[i] - sizeof(ew_vec4) + 1, sizes[i]);
    }
    assert_int_equal(ew_sources_capacity(1u << 30), ew_sources_capacity(65536));
}

/* ---- What every kind may have ---- */

/* The last members of source 1 of a kind. */
static ew_emission *second_emission(field *f, int kind)
{
    void *const lists[EW_KIND_COUNT] = {f->points, f->lines, f->tori, f->curves, f->paths};
    return (ew_emission *)(void *)((char *)lists[kind] + ew_kinds[kind]->size + ew_kinds[kind]->emission_offset);
}

typedef struct bad_emission {
    ew_emission emission;
    const char *field;
} bad_emission;

static const bad_emission bad_emissions[] = {
    {{.coefficient = 1, .core = 0.1, .reach = 0.1}, "reach"},
    {{.coefficient = 1, .core = 0.1, .reach = 0.05}, "reach"},
    {{.coefficient = 1, .reach = 1e-3}, "reach"}, /* the core is epsilon */
    {{.coefficient = 1, .reach = 5e-4}, "reach"},
    {{.coefficient = 1, .reach = (double)INFINITY}, "reach"},
    {{.coefficient = 1, .brightness = 1, .core = 0.1, .reach = 1}, "brightness"},
    {{.brightness = 1, .core = 0.1}, "brightness"},
    {{.brightness = (double)NAN, .core = 0.1, .reach = 1}, "brightness"},
    {{.coefficient = 1, .sharpness = 2}, "sharpness"},
    {{.coefficient = 1, .reach = 1, .sharpness = 0.5}, "sharpness"},
    {{.coefficient = 1, .reach = 1, .sharpness = -2}, "sharpness"},
    {{.coefficient = 1, .reach = 1, .sharpness = (double)NAN}, "sharpness"},
    {{.coefficient = 1, .reach = 1, .sharpness = (double)INFINITY}, "sharpness"},
    {{.coefficient = 1, .core = (double)INFINITY}, "core"},
};

static void bad_cores_reaches_and_brightness_are_refused_by_name_in_every_kind(void **state)
{
    (void)state;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        for (size_t i = 0; i < sizeof bad_emissions / sizeof bad_emissions[0]; ++i) {
            field f;
            char expected[64];
            make_field(&f);
            *second_emission(&f, kind) = bad_emissions[i].emission;
            snprintf(expected, sizeof expected, "%s[1].%s", ew_kinds[kind]->list_name, bad_emissions[i].field);
            expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, expected);
        }
}

static void good_cores_reaches_and_brightness_are_taken_in_every_kind(void **state)
{
    (void)state;
    static const ew_emission good[] = {
        {.coefficient = 1, .core = 1e-2},
        {.coefficient = 1, .reach = 2e-3},
        {.brightness = 3, .reach = 1},
        {.brightness = 3, .core = 0.5, .reach = 0.500001, .sharpness = 1},
        {.coefficient = 3, .core = 0.5, .reach = 2, .sharpness = 8},
        {.reach = 1}, /* dark */
    };
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        for (size_t i = 0; i < sizeof good / sizeof good[0]; ++i) {
            field f;
            ew_sources taken = {0};
            make_field(&f);
            *second_emission(&f, kind) = good[i];
            assert_int_equal(create(&f.desc, &taken, NULL), EW_OK);
            ew_sources_destroy(&taken, &ew_default_allocator);
        }
}

/* Epsilon may be left out once every source has a core. */
static void a_source_without_any_core_is_refused_by_name(void **state)
{
    (void)state;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        field f;
        char expected[64];
        make_field(&f);
        f.desc.epsilon = 0;
        for (int k = 0; k < EW_KIND_COUNT; ++k) {
            ew_emission *second = second_emission(&f, k);
            second->core = k == kind ? 0 : 0.1;
            ((ew_emission *)(void *)((char *)second - ew_kinds[k]->size))->core = 0.1;
        }
        snprintf(expected, sizeof expected, "%s[1].core", ew_kinds[kind]->list_name);
        expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, expected);
        expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, "epsilon");
        second_emission(&f, kind)->core = 0.1;
        ew_sources taken = {0};
        assert_int_equal(create(&f.desc, &taken, NULL), EW_OK);
        ew_sources_destroy(&taken, &ew_default_allocator);
    }
}

static void wrong_counts_of_points_are_refused_by_name(void **state)
{
    (void)state;
    static const struct {
        ew_path_kind kind;
        size_t count;
        int is_closed;
        const char *field;
    } bad[] = {
        {EW_PATH_POLYLINE, 0, 0, "paths[1].points"},    {EW_PATH_POLYLINE, 1, 0, "paths[1].points"},
        {EW_PATH_POLYLINE, 2, 1, "paths[1].points"},    {EW_PATH_BSPLINE, 2, 0, "paths[1].points"},
        {EW_PATH_BSPLINE, 2, 1, "paths[1].points"},     {EW_PATH_BEZIER, 3, 0, "paths[1].points"},
        {EW_PATH_BEZIER, 1, 0, "paths[1].points"},      {EW_PATH_BEZIER, 4, 1, "paths[1].is_closed"},
        {EW_PATH_CATMULL_ROM, 1, 0, "paths[1].points"}, {EW_PATH_CATMULL_ROM, 2, 1, "paths[1].points"},
        {EW_PATH_POLYLINE, 4, 2, "paths[1].is_closed"}, {EW_PATH_POLYLINE, 4, -1, "paths[1].is_closed"},
        {(ew_path_kind)4, 4, 0, "paths[1].kind"},       {(ew_path_kind)-1, 4, 0, "paths[1].kind"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        field f;
        make_field(&f);
        f.paths[1].kind = bad[i].kind;
        f.paths[1].point_count = bad[i].count;
        f.paths[1].is_closed = bad[i].is_closed;
        expect_refused(&f.desc, EW_ERROR_INVALID_ARGUMENT, bad[i].field);
    }
}

static void the_largest_lists_are_taken(void **state)
{
    (void)state;
    ew_point *points = calloc(EW_MAX_POINTS + 1, sizeof *points);
    ew_line *lines = calloc(EW_MAX_LINES + 1, sizeof *lines);
    ew_torus *tori = calloc(EW_MAX_TORI + 1, sizeof *tori);
    ew_curve *curves = calloc(EW_MAX_CURVES + 1, sizeof *curves);
    double weights[EW_MAX_WEIGHTS] = {0};
    assert_true(points && lines && tori && curves);
    for (size_t i = 0; i <= EW_MAX_LINES; ++i)
        lines[i].direction[0] = 1;
    for (size_t i = 0; i <= EW_MAX_TORI; ++i)
        tori[i].axis[0] = 1;
    for (size_t i = 0; i <= EW_MAX_CURVES; ++i)
        curves[i].domain[1] = 1;
    ew_sources_desc largest[] = {
        {.points = points, .point_count = EW_MAX_POINTS, .epsilon = 1},
        {.lines = lines, .line_count = EW_MAX_LINES, .epsilon = 1},
        {.tori = tori, .torus_count = EW_MAX_TORI, .epsilon = 1},
        {.curves = curves, .curve_count = EW_MAX_CURVES, .epsilon = 1},
        {.curves = curves, .curve_count = 3, .epsilon = 1},
    };
    size_t *counts[] = {&largest[0].point_count, &largest[1].line_count, &largest[2].torus_count, &largest[3].curve_count};
    ew_sources taken = {0};
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(create(&largest[i], &taken, NULL), EW_OK);
        ++*counts[i];
        assert_int_equal(create(&largest[i], &taken, NULL), EW_ERROR_TOO_MANY_SOURCES);
    }
    for (size_t i = 0; i < largest[4].curve_count; ++i) {
        curves[i].weights = weights;
        curves[i].weight_count = EW_MAX_WEIGHTS;
    }
    assert_int_equal(create(&largest[4], &taken, NULL), EW_OK);
    assert_int_equal(taken.weight_piece_count, 3 * (EW_MAX_WEIGHTS - 2));
    ew_sources_destroy(&taken, &ew_default_allocator);
    free(points);
    free(lines);
    free(tori);
    free(curves);
}

static void the_limits_of_what_is_allowed_are_taken(void **state)
{
    (void)state;
    field f;
    make_field(&f);
    f.desc.epsilon = DBL_MIN;
    f.points[1].coefficient = 0;
    memset(f.points[1].color, 0, sizeof f.points[1].color);
    f.tori[1].radius = 0;
    memcpy(f.lines[1].direction, (double[3]){1e-300, 0, 0}, sizeof f.lines[1].direction);
    memcpy(f.tori[1].axis, (double[3]){0, 1e300, -1e300}, sizeof f.tori[1].axis);
    memset(f.curves[1].polynomial, 0, sizeof f.curves[1].polynomial); /* a single point */
    memset(f.weights, 0, sizeof f.weights);
    ew_sources taken = {0};
    assert_int_equal(create(&f.desc, &taken, NULL), EW_OK);
    ew_sources_destroy(&taken, &ew_default_allocator);

    ew_sources_desc none = {.epsilon = 1};
    assert_int_equal(create(&none, &taken, NULL), EW_OK);
    ew_sources_destroy(&taken, &ew_default_allocator);
    /* An empty list may as well be a pointer to nothing. */
    none.points = f.points;
    none.curves = f.curves;
    assert_int_equal(create(&none, &taken, NULL), EW_OK);
    ew_sources_destroy(&taken, &ew_default_allocator);
}

static void success_leaves_the_error_alone(void **state)
{
    (void)state;
    field f;
    make_field(&f);
    ew_error error = {EW_ERROR_SHADER, "an older error"};
    ew_sources taken = {0};
    assert_int_equal(create(&f.desc, &taken, &error), EW_OK);
    assert_int_equal(error.code, EW_ERROR_SHADER);
    assert_string_equal(error.text, "an older error");
    ew_sources_destroy(&taken, &ew_default_allocator);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_out_of_range_is_refused_by_name),
        cmocka_unit_test(every_bad_weight_is_refused_by_name),
        cmocka_unit_test(directions_of_no_length_are_refused),
        cmocka_unit_test(domains_of_no_length_are_refused),
        cmocka_unit_test(lists_and_counts_that_disagree_are_refused),
        cmocka_unit_test(more_sources_than_an_effect_holds_are_refused),
        cmocka_unit_test(uniform_blocks_are_used_up_to_64_kib),
        cmocka_unit_test(bad_cores_reaches_and_brightness_are_refused_by_name_in_every_kind),
        cmocka_unit_test(good_cores_reaches_and_brightness_are_taken_in_every_kind),
        cmocka_unit_test(a_source_without_any_core_is_refused_by_name),
        cmocka_unit_test(wrong_counts_of_points_are_refused_by_name),
        cmocka_unit_test(the_largest_lists_are_taken),
        cmocka_unit_test(the_limits_of_what_is_allowed_are_taken),
        cmocka_unit_test(success_leaves_the_error_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
