/*
 * The reference's luminances against closed forms and brute force in extended precision.
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
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* ---- Closed forms ------------------------------------------------------------------------------------------------------- */

/* The integral from s0 to s1 of 1/sqrt(b^2 + k (s - sc)^2) / (s + beta)^2: with y = 1/(s + beta) it becomes that of
 * y / sqrt(k + 2 B y + C y^2), B = -k (sc + beta), C = b^2 + k (sc + beta)^2, whose antiderivative is in every table. */
static long double table_integral(long double b, long double k, long double sc, long double beta, long double s0,
                                  long double s1)
{
    long double sigma = sc + beta, B = -k * sigma, C = b * b + k * sigma * sigma;
    long double result = 0;
    for (int end = 0; end < 2; end++) {
        long double y = 1 / ((end ? s1 : s0) + beta);
        /* asinh of (C y + B) / sqrt(C k - B^2), where C k - B^2 = k b^2 */
        long double antiderivative =
            sqrtl(k + 2 * B * y + C * y * y) / C - B / (C * sqrtl(C)) * asinhl((C * y + B) / (sqrtl(k) * b));
        result += end ? -antiderivative : antiderivative;
    }
    return result;
}

/* The same with the distance's floor at epsilon. */
static double floored_integral(long double b, long double k, long double sc, long double beta, long double s_max,
                               long double epsilon)
{
    if (b >= epsilon) return (double)table_integral(b, k, sc, beta, 0, s_max);
    long double half = sqrtl((epsilon - b) * (epsilon + b) / k);
    long double enter = fminl(fmaxl(sc - half, 0), s_max), leave = fminl(fmaxl(sc + half, 0), s_max);
    return (double)(table_integral(b, k, sc, beta, 0, enter) + (leave - enter) / ((enter + beta) * (leave + beta)) / epsilon +
                    table_integral(b, k, sc, beta, leave, s_max));
}

/* The luminance of a point, or with a direction of a line, whose coefficient is 1. The squared distance along the ray is
 * k (s - sc)^2 + b^2; for a line, all components along it drop out. */
static double closed_form(const double position[3], const double *direction, const reference_ray *ray, double epsilon)
{
    long double d[3], m[3], k = 0, dm = 0, b2 = 0, norm2 = 0, d_along = 0, m_along = 0;
    for (int j = 0; j < 3; j++) {
        d[j] = (long double)ray->end[j] - ray->start[j];
        m[j] = (long double)position[j] - ray->start[j];
        if (!direction) continue;
        norm2 += (long double)direction[j] * direction[j];
        d_along += d[j] * direction[j];
        m_along += m[j] * direction[j];
    }
    for (int j = 0; j < 3; j++) {
        if (direction) {
            d[j] -= d_along / norm2 * direction[j];
            m[j] -= m_along / norm2 * direction[j];
        }
        k += d[j] * d[j];
        dm += d[j] * m[j];
    }
    long double sc = dm / k;
    for (int j = 0; j < 3; j++)
        b2 += (m[j] - sc * d[j]) * (m[j] - sc * d[j]);
    return ray->decay_alpha * floored_integral(sqrtl(b2), k, sc, ray->decay_beta, ray->s_max, epsilon);
}

static void points_and_lines_match_their_closed_forms(void **state)
{
    (void)state;
    uint64_t random = 2;
    double worst = 0;
    for (int i = 0; i < 4000; i++) {
        reference_ray ray = random_ray(&random, i % 2 ? 20 : 1e4);
        double epsilon = log_uniform(&random, 1e-6, 1e-1), position[3], direction[3];
        point_near_ray(&random, &ray, i % 3 ? log_uniform(&random, 1e-8, 3) : 0.5 * epsilon, position);
        random_vector(&random, 1, direction);
        ew_point point = {.coefficient = 2};
        ew_line line = {.coefficient = 2};
        memcpy(point.position, position, sizeof position);
        memcpy(line.position, position, sizeof position);
        memcpy(line.direction, direction, sizeof direction);
        bool is_line = i % 4 >= 2;
        ew_sources_desc sources = {.epsilon = epsilon};
        if (is_line)
            sources.lines = &line, sources.line_count = 1;
        else
            sources.points = &point, sources.point_count = 1;

        double truth = 2 * closed_form(position, is_line ? direction : NULL, &ray, epsilon);

        reference_value value;
        bool reliable = reference_luminance(workspace, &sources, &ray, &value, NULL);
        double error = fabs(value.luminance - truth);
        if (error / truth > worst) worst = error / truth;
        if (!reliable || error > 1e-9 * truth)
            fail_msg("case %d: %.12g +- %.1e, in closed form %.12g", i, value.luminance, value.error, truth);
    }
    print_message("largest relative error against closed forms: %.1e\n", worst);
}

/* ---- Brute force -------------------------------------------------------------------------------------------------------- */

static void random_curves_match_brute_force(void **state)
{
    (void)state;
    uint64_t random = 3;
    double weights[64];
    for (int i = 0; i < 64; i++)
        weights[i] = i % 5 == 4 ? 0 : random_between(&random, 0, 1);
    for (int i = 0; i < 120; i++) {
        int shape = i % CURVE_SHAPES;
        ew_curve curve = random_curve(&random, shape);
        reference_ray ray = random_ray(&random, i % 2 ? 20 : 1e3);
        double shift[3];
        point_near_ray(&random, &ray, log_uniform(&random, 1e-4, 1), shift);
        for (int k = 0; k < 3; k++) {
            double t = 0.4;
            curve.polynomial[0][k] = shift[k] - t * curve.polynomial[1][k] - t * t * curve.polynomial[2][k];
        }
        const size_t counts[] = {0, 1, 2, 3, 7, 64};
        curve.weight_count = curve_is_ambiguous(shape) ? 0 : counts[(i / CURVE_SHAPES) % 6];
        if (curve.weight_count) curve.weights = weights;
        ew_sources_desc sources = {.curves = &curve, .curve_count = 1, .epsilon = log_uniform(&random, 1e-4, 1e-1)};
        assert_matches_brute_force(&sources, &ray, 0, "curve", i);
    }
}

/* Once overlooked: the one short stretch of a ray that sees the inside of an arc whose weights are 0 at both ends. The light is
 * linear in the weights. */
static void arcs_dark_at_both_ends_shine_in_between(void **state)
{
    (void)state;
    static const double weights[3][3] = {{0, 1, 0}, {1, 1, 1}, {1, 0, 1}};
    double luminance[3];
    for (int i = 0; i < 3; i++) {
        ew_curve curve = {.polynomial = {{0, 0, 0}, {0.01, -0.0995, 0}, {0, 0, 0.001}},
                          .domain = {0, 1},
                          .weights = weights[i],
                          .weight_count = 3,
                          .coefficient = 1};
        ew_sources_desc sources = {.curves = &curve, .curve_count = 1, .epsilon = 1e-4};
        reference_ray ray = {.start = {-300, 10, 0}, .end = {300, 10, 0}, .s_max = 1, .decay_alpha = 1, .decay_beta = 1};
        reference_value value;
        assert_true(reference_luminance(workspace, &sources, &ray, &value, NULL));
        luminance[i] = value.luminance;
    }
    assert_true(luminance[0] > 0);
    assert_true(fabs(luminance[0] - (luminance[1] - luminance[2])) < 1e-6 * luminance[0]);
}

static void random_tori_match_brute_force(void **state)
{
    (void)state;
    uint64_t random = 4;
    for (int i = 0; i < 120; i++) {
        reference_ray ray = random_ray(&random, i % 2 ? 20 : 1e3);
        ew_torus torus = {.coefficient = 3, .radius = i % 10 == 0 ? 0 : log_uniform(&random, 1e-2, 3)};
        random_vector(&random, 1, torus.axis);
        point_near_ray(&random, &ray, log_uniform(&random, 1e-4, 3), torus.center);
        ew_sources_desc sources = {.tori = &torus, .torus_count = 1, .epsilon = log_uniform(&random, 1e-4, 1e-1)};
        assert_matches_brute_force(&sources, &ray, 0, "torus", i);
    }
}

static void hard_rays_match_brute_force(void **state)
{
    (void)state;
    static const double from[][3] = {{-4, 0, 0},    {0, 0, 0},    {0, 0, -4},    {-4, 1, 0},
                                     {-4, 0, 1e-5}, {0, 0, 1e-3}, {1e-7, 0, -4}, {-4, 1 - 1e-4, 0}};
    static const double to[][3] = {{4, 0, 0},    {4, 0, 0},    {0, 0, 4},    {4, 1, 0},
                                   {4, 0, 1e-5}, {8, 0, 1e-3}, {1e-7, 0, 4}, {4, 1 - 1e-4, 0}};
    ew_point point = {.position = {0, 0, 0}, .coefficient = 1};
    ew_line line = {.position = {7, 0, 0}, .direction = {2, 0, 0}, .coefficient = 1};
    ew_torus torus = {.axis = {0, 0, 1}, .radius = 1, .coefficient = 1};
    ew_torus dot = {.axis = {0, 0, 1}, .radius = 0, .coefficient = 1};
    ew_curve straight = {.polynomial = {{-1, 0, 0}, {2, 0, 0}, {0, 0, 0}}, .domain = {0, 1}, .coefficient = 1};
    ew_curve parabola = {.polynomial = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, .domain = {-1, 1}, .coefficient = 1};
    ew_curve folded = {.polynomial = {{-1, 0, 0}, {4, 0, 0}, {-4, 0, 0}}, .domain = {0, 1}, .coefficient = 1};
    ew_curve hairpin = {.polynomial = {{0, 0, 0}, {0, 0.01, 0}, {2, 0, 0}}, .domain = {-1, 1}, .coefficient = 1};
    const ew_sources_desc fields[] = {
        {.points = &point, .point_count = 1},  {.lines = &line, .line_count = 1},       {.tori = &torus, .torus_count = 1},
        {.tori = &dot, .torus_count = 1},      {.curves = &straight, .curve_count = 1}, {.curves = &parabola, .curve_count = 1},
        {.curves = &folded, .curve_count = 1}, {.curves = &hairpin, .curve_count = 1},
    };
    for (size_t ray_number = 0; ray_number < sizeof from / sizeof from[0]; ray_number++)
        for (size_t field = 0; field < sizeof fields / sizeof fields[0]; field++) {
            reference_ray ray = {.s_max = 1, .decay_alpha = 1, .decay_beta = 0.5};
            memcpy(ray.start, from[ray_number], sizeof ray.start);
            memcpy(ray.end, to[ray_number], sizeof ray.end);
            ew_sources_desc sources = fields[field];
            sources.epsilon = 1e-4;
            assert_matches_brute_force(&sources, &ray, 0, "ray, field", (int)(10 * ray_number + field));
        }
}

static void shares_add_up_in_the_order_of_the_kinds(void **state)
{
    (void)state;
    uint64_t random = 5;
    ew_point points[2] = {{.position = {1, 0, 0}, .coefficient = 1}, {.position = {0, 2, 0}, .coefficient = 0}};
    ew_line line = {.position = {0, 1, 0}, .direction = {0, 0, 3}, .coefficient = 2};
    ew_torus torus = {.axis = {0, 0, 1}, .radius = 1, .coefficient = 3};
    ew_curve curve = random_curve(&random, 0);
    const ew_sources_desc all = {
        .points = points,
        .point_count = 2,
        .lines = &line,
        .line_count = 1,
        .tori = &torus,
        .torus_count = 1,
        .curves = &curve,
        .curve_count = 1,
        .epsilon = 1e-3,
    };
    const ew_sources_desc alone[] = {
        {.points = points, .point_count = 1, .epsilon = 1e-3}, {.points = points + 1, .point_count = 1, .epsilon = 1e-3},
        {.lines = &line, .line_count = 1, .epsilon = 1e-3},    {.tori = &torus, .torus_count = 1, .epsilon = 1e-3},
        {.curves = &curve, .curve_count = 1, .epsilon = 1e-3},
    };
    for (int i = 0; i < 20; i++) {
        reference_ray ray = random_ray(&random, 20);
        reference_value sum, shares[5], value;
        double total = 0;
        assert_true(reference_luminance(workspace, &all, &ray, &sum, shares));
        for (int k = 0; k < 5; k++) {
            assert_true(reference_luminance(workspace, &alone[k], &ray, &value, NULL));
            assert_true(value.luminance == shares[k].luminance);
            total += value.luminance;
        }
        assert_true(shares[1].luminance == 0);
        assert_true(fabs(total - sum.luminance) <= 1e-14 * total);
    }
}

static void nothing_shines_before_the_ray_starts(void **state)
{
    (void)state;
    ew_point point = {.coefficient = 1};
    ew_sources_desc sources = {.points = &point, .point_count = 1, .epsilon = 1e-3};
    reference_ray ray = {.start = {-1, 0, 0}, .end = {1, 0, 0}, .s_max = 0, .decay_alpha = 1, .decay_beta = 1};
    reference_value value;
    assert_true(reference_luminance(workspace, &sources, &ray, &value, NULL));
    assert_true(value.luminance == 0);
    ray.s_max = 1;
    sources.point_count = 0;
    assert_true(reference_luminance(workspace, &sources, &ray, &value, NULL));
    assert_true(value.luminance == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_and_lines_match_their_closed_forms),
        cmocka_unit_test(random_curves_match_brute_force),
        cmocka_unit_test(arcs_dark_at_both_ends_shine_in_between),
        cmocka_unit_test(random_tori_match_brute_force),
        cmocka_unit_test(hard_rays_match_brute_force),
        cmocka_unit_test(shares_add_up_in_the_order_of_the_kinds),
        cmocka_unit_test(nothing_shines_before_the_ray_starts),
    };
    return cmocka_run_group_tests_name("reference", tests, create_workspace, destroy_workspace);
}
