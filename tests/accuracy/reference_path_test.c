/*
 * The reference's paths: against brute force in extended precision, curves, and paths that are the same by other points.
 */
#include "brute_force.h"
#include "path_parts.h"
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

enum { MAX_POINTS = 201 };

static double path_luminance(const ew_path *path, const reference_ray *ray)
{
    return value_of(&(ew_sources_desc){.paths = path, .path_count = 1}, ray).luminance;
}

/* A ray with cores of pixels, past or through the middle of the scene. */
static reference_ray random_world_ray(uint64_t *random)
{
    reference_ray ray = {.s_max = HUGE_VAL, .is_world = true};
    double target[3];
    random_vector(random, 5, ray.start);
    random_vector(random, 1.5, target);
    for (int i = 0; i < 3; i++)
        ray.end[i] = ray.start[i] + 0.1 * (target[i] - ray.start[i]);
    ray.least_core[1] = random_chance(random, 0.5) ? 0 : log_uniform(random, 1e-4, 1e-1);
    return ray;
}

static void random_points(uint64_t *random, double points[][3], size_t count)
{
    for (size_t i = 0; i < count; i++)
        random_vector(random, 1.5, points[i]);
}

/* ---- Brute force -------------------------------------------------------------------------------------------------------- */

static void polylines_and_bsplines_match_brute_force(void **state)
{
    (void)state;
    uint64_t random = 21;
    double points[8][3], weights[7];
    for (int i = 0; i < 7; i++)
        weights[i] = i == 3 ? 0 : random_unit(&random);
    for (int i = 0; i < 150; i++) {
        reference_ray ray = random_world_ray(&random);
        ew_path path = {.kind = i % 2 ? EW_PATH_BSPLINE : EW_PATH_POLYLINE,
                        .points = (const double(*)[3])points,
                        .point_count = 3 + random_index(&random, 6),
                        .is_closed = i % 4 < 2,
                        .coefficient = 1,
                        .core = log_uniform(&random, 1e-3, 0.3)};
        ray.s_max = 30;
        random_points(&random, points, path.point_count);
        if (i % 5 == 1) memcpy(points[1], points[2], sizeof points[1]);
        if (i % 5 == 2) memcpy(points[2], points[0], sizeof points[2]);
        path.reach = path.core * log_uniform(&random, 2, 1e3);
        /* Which weight counts where a piece is a point, or runs back over itself, is undefined. */
        bool is_ambiguous = i % 5 == 1 || (i % 5 == 2 && path.kind == EW_PATH_BSPLINE);
        if (i % 3 == 0 && !is_ambiguous) path.weights = weights, path.weight_count = i % 6 ? 7 : 2;
        ew_sources_desc sources = {.paths = &path, .path_count = 1};
        assert_matches_brute_force(&sources, &ray, 1, "path", i);
    }
}

/* ---- The same by other points ------------------------------------------------------------------------------------------- */

/* Divides the way from a to b evenly into points. */
static void divide(const double a[3], const double b[3], double points[][3], size_t pieces)
{
    for (size_t i = 0; i <= pieces; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] = a[k] + (double)i / (double)pieces * (b[k] - a[k]);
}

static void a_straight_path_may_be_cut(void **state)
{
    (void)state;
    static const size_t cuts[] = {1, 2, 6, 24, 200};
    static const double weights[] = {0.2, 1};
    uint64_t random = 22;
    for (int i = 0; i < 12; i++) {
        reference_ray ray = random_world_ray(&random);
        double ends[2][3], points[MAX_POINTS][3];
        random_points(&random, ends, 2);
        ew_curve curve = {.domain = {0, 1}, .coefficient = 2, .core = log_uniform(&random, 1e-3, 0.1)};
        curve.reach = curve.core * log_uniform(&random, 2, 1e3);
        if (i % 2) curve.weights = weights, curve.weight_count = 2;
        for (int k = 0; k < 3; k++) {
            curve.polynomial[0][k] = ends[0][k];
            curve.polynomial[1][k] = ends[1][k] - ends[0][k];
        }
        double truth = value_of(&(ew_sources_desc){.curves = &curve, .curve_count = 1}, &ray).luminance;
        for (size_t cut = 0; cut < sizeof cuts / sizeof *cuts; cut++) {
            ew_path path = {.points = (const double(*)[3])points, .point_count = cuts[cut] + 1, .coefficient = 2};
            path.core = curve.core, path.reach = curve.reach, path.weights = curve.weights;
            path.weight_count = curve.weight_count;
            divide(ends[0], ends[1], points, cuts[cut]);
            assert_close(path_luminance(&path, &ray), truth, 1e-8, 1e-3);
            path.kind = EW_PATH_CATMULL_ROM;
            assert_close(path_luminance(&path, &ray), truth, 1e-8, 1e-3);
        }
    }
}

/* Quadratic pieces raised to cubic ones. */
static void bezier_paths_may_be_bsplines(void **state)
{
    (void)state;
    uint64_t random = 23;
    for (int i = 0; i < 40; i++) {
        reference_ray ray = random_world_ray(&random);
        double points[6][3], cubics[13][3];
        random_points(&random, points, 6);
        ew_path path = {.kind = EW_PATH_BSPLINE, .points = (const double(*)[3])points, .point_count = 6, .coefficient = 1};
        path.core = 0.02, path.reach = 1;
        for (size_t span = 0; span < 4; span++)
            path_span(&path, span, &cubics[3 * span]);
        double truth = path_luminance(&path, &ray);
        path.kind = EW_PATH_BEZIER;
        path.points = (const double(*)[3])cubics;
        path.point_count = 13;
        assert_close(path_luminance(&path, &ray), truth, 1e-6, 1e-3);
    }
}

/* By its own formula (Catmull, Rom: "A Class of Local Interpolating Splines", 1974, with tension 1/2) at t between b and c. */
static double catmull_rom(double a, double b, double c, double d, double t)
{
    return 0.5 * (2 * b + t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * b - a - 3 * c + d))));
}

/* Cut into chords, short enough to be the curve itself. */
static void catmull_rom_paths_are_what_their_chords_are(void **state)
{
    (void)state;
    enum { CHORDS = 60 };
    uint64_t random = 24;
    double worst = 0;
    for (int i = 0; i < 8; i++) {
        reference_ray ray = random_world_ray(&random);
        double points[4][3], chords[4 * CHORDS][3];
        int is_closed = i % 2;
        size_t spans = is_closed ? 4 : 3;
        random_points(&random, points, 4);
        for (size_t span = 0; span < spans; span++)
            for (int k = 0; k < 3; k++) {
                double a = points[(span + 3) % 4][k], b = points[span][k], c = points[(span + 1) % 4][k];
                double d = points[(span + 2) % 4][k];
                if (!is_closed && span == 0) a = 2 * b - c;
                if (!is_closed && span == 2) d = 2 * c - b;
                for (int t = 0; t < CHORDS; t++)
                    chords[span * CHORDS + (size_t)t][k] = catmull_rom(a, b, c, d, t / (double)CHORDS);
            }
        if (!is_closed) memcpy(chords[3 * CHORDS], points[3], sizeof points[3]);
        ew_path path = {.kind = EW_PATH_CATMULL_ROM, .points = (const double(*)[3])points, .point_count = 4, .coefficient = 1};
        path.is_closed = is_closed, path.core = 0.1, path.reach = 0.6;
        double truth = path_luminance(&path, &ray);
        path.kind = EW_PATH_POLYLINE;
        path.points = (const double(*)[3])chords;
        path.point_count = spans * CHORDS + !is_closed;
        double value = path_luminance(&path, &ray);
        worst = fmax(worst, fabs(value - truth) / fmax(truth, 0.1));
    }
    print_message("largest difference: %.1e\n", worst);
    assert_true(worst < 5e-3);
}

static void paths_have_the_same_light_in_every_unit(void **state)
{
    (void)state;
    uint64_t random = 25;
    for (int i = 0; i < 40; i++) {
        static const double scales[] = {1e-3, 1e4, 1e16};
        double scale = scales[i % 3], points[7][3];
        reference_ray ray = random_world_ray(&random);
        random_points(&random, points, 7);
        ew_path path = {
            .kind = (ew_path_kind)(i % 4), .points = (const double(*)[3])points, .point_count = 7, .brightness = 0.8};
        path.core = 0.02, path.reach = 1, path.sharpness = 2;
        double truth = path_luminance(&path, &ray);
        for (int p = 0; p < 7; p++)
            for (int k = 0; k < 3; k++)
                points[p][k] *= scale;
        for (int k = 0; k < 3; k++)
            ray.start[k] *= scale, ray.end[k] *= scale;
        ray.least_core[1] *= scale;
        path.core *= scale, path.reach *= scale;
        assert_close(path_luminance(&path, &ray), truth, 1e-7, 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polylines_and_bsplines_match_brute_force),
        cmocka_unit_test(a_straight_path_may_be_cut),
        cmocka_unit_test(bezier_paths_may_be_bsplines),
        cmocka_unit_test(catmull_rom_paths_are_what_their_chords_are),
        cmocka_unit_test(paths_have_the_same_light_in_every_unit),
    };
    return cmocka_run_group_tests_name("reference, paths", tests, create_workspace, destroy_workspace);
}
