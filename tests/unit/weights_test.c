/* Weight pieces against the recursive definition of the B-spline: equations (14) to (16). */
#include "base/allocator.h"
#include "check.h"
#include "packed.h"
#include "plan/plan.h"

#include <stdlib.h>

enum { MAX_COUNT = 64 };

/* Knot i of the clamped uniform quadratic B-spline of n weights over [0, 1], equation (16): two knots repeated at either end.
 */
static double knot(size_t i, size_t n)
{
    if (i <= 2) return 0;
    if (i >= n) return 1;
    return (double)(i - 2) / (double)(n - 2);
}

/* Equation (14) by Cox and de Boor; the spans are half open, but for the last one, which has its end. */
static double basis(size_t i, int degree, size_t n, double t)
{
    double a = knot(i, n), b = knot(i + 1, n);
    if (degree == 0) return (a <= t && t < b) || (a < b && b == 1 && t == 1);
    double c = knot(i + (size_t)degree, n), d = knot(i + (size_t)degree + 1, n);
    double left = c > a ? (t - a) / (c - a) * basis(i, degree - 1, n, t) : 0;
    double right = d > b ? (d - t) / (d - b) * basis(i + 1, degree - 1, n, t) : 0;
    return left + right;
}

/* Equation (15). */
static double spline(const double *weights, size_t n, double t)
{
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        sum += weights[i] * basis(i, 2, n, t);
    return sum;
}

/* Curves that differ in their weights alone. */
static ew_sources make_sources(ew_curve *curves, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        curves[i].domain[1] = 1;
        curves[i].coefficient = 1;
    }
    ew_sources_desc desc = {.curves = curves, .curve_count = count, .epsilon = 1};
    ew_sources sources = {0};
    assert_int_equal(ew_sources_set(&sources, &desc, &ew_default_allocator, NULL), EW_OK);
    return sources;
}

/* S(t) from `count` pieces, as the block's description has it. */
static double piecewise(const struct ew_weight_block *pieces, size_t count, double t)
{
    size_t piece = (size_t)(t * (double)count);
    if (piece == count) piece = count - 1;
    double f = t * (double)count - (double)piece;
    const ew_vec4 *p = &pieces[piece].polynomial;
    return (double)p->x + f * ((double)p->y + f * (double)p->z);
}

static void pieces_are_the_recursive_spline(void **state)
{
    (void)state;
    double weights[MAX_COUNT];
    srand(1);
    for (size_t n = 3; n <= MAX_COUNT; ++n) {
        for (size_t i = 0; i < n; ++i)
            weights[i] = rand() % 5 ? rand() / (double)RAND_MAX : 0;
        ew_curve curve = {.weights = weights, .weight_count = n};
        ew_sources sources = make_sources(&curve, 1);
        assert_int_equal(sources.weight_piece_count, n - 2);
        for (int step = 0; step <= 1000; ++step) {
            double t = step / 1000.0;
            /* Three floats, each rounded once; the place along the piece is not. */
            check_close(piecewise(packed_weights(&sources), n - 2, t), spline(weights, n, t), 3e-7);
        }
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

static void the_papers_example_has_its_values(void **state)
{
    (void)state;
    const double weights[] = {1.0, 0.2, 0.6, 1.0, 0.5, 0.8, 1.0};
    ew_curve curve = {.weights = weights, .weight_count = 7};
    ew_sources sources = make_sources(&curve, 1);
    /* At a simple knot the quadratic spline is the mean of its two weights; at the ends it is the first and last. */
    const double knots[] = {1.0, 0.4, 0.8, 0.75, 0.65, 1.0};
    for (int i = 0; i <= 5; ++i)
        check_close(piecewise(packed_weights(&sources), 5, i / 5.0), knots[i], 2e-7);
    ew_sources_destroy(&sources, &ew_default_allocator);
}

static void even_weights_are_even_everywhere(void **state)
{
    (void)state;
    double weights[MAX_COUNT];
    for (size_t i = 0; i < MAX_COUNT; ++i)
        weights[i] = 0.75;
    for (size_t n = 1; n <= MAX_COUNT; ++n) {
        ew_curve curve = {.weights = weights, .weight_count = n};
        ew_sources sources = make_sources(&curve, 1);
        for (int step = 0; step <= 100; ++step)
            assert_true(piecewise(packed_weights(&sources), sources.weight_piece_count, step / 100.0) == 0.75);
        ew_sources_destroy(&sources, &ew_default_allocator);
    }
}

static void one_weight_is_a_constant_and_two_are_a_ramp(void **state)
{
    (void)state;
    const double weights[] = {0.25, 2};
    ew_curve curves[2] = {{.weights = weights, .weight_count = 1}, {.weights = weights, .weight_count = 2}};
    ew_sources sources = make_sources(curves, 2);
    assert_int_equal(sources.weight_piece_count, 2);
    for (int step = 0; step <= 8; ++step) {
        double t = step / 8.0;
        check_close(piecewise(&packed_weights(&sources)[0], 1, t), 0.25, 0);
        check_close(piecewise(&packed_weights(&sources)[1], 1, t), 0.25 + 1.75 * t, 0);
    }
    ew_sources_destroy(&sources, &ew_default_allocator);
}

/* The curves' pieces stand one after the other, and each curve's block says where its own are. */
static void each_curve_finds_its_own_pieces(void **state)
{
    (void)state;
    double lists[4][5] = {{1, 2, 3, 4, 5}, {0}, {6, 7, 8, 9, 10}, {11}};
    ew_curve curves[4] = {{.weights = lists[0], .weight_count = 5},
                          {.weights = NULL, .weight_count = 0},
                          {.weights = lists[2], .weight_count = 4},
                          {.weights = lists[3], .weight_count = 1}};
    ew_sources sources = make_sources(curves, 4);
    double expected[4][5];
    memcpy(expected, lists, sizeof lists);
    memset(lists, 0, sizeof lists); /* they have their own copy */

    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.viewport_width = frame.viewport_height = 16;
    frame.interval_start = 1;
    frame.interval_end = 2;
    ew_plan plan;
    assert_int_equal(ew_plan_frame(&plan, &sources, NULL, &frame, NULL), EW_OK);
    const size_t piece_counts[4] = {3, 0, 2, 1};
    for (int i = 0; i < 4; ++i) {
        size_t first = (size_t)packed_curve(&sources, i)->domain.z, count = (size_t)packed_curve(&sources, i)->domain.w;
        assert_int_equal(count, piece_counts[i]);
        assert_true(first + count <= sources.weight_piece_count);
        if (count == 0) continue;
        check_close(piecewise(&packed_weights(&sources)[first], count, 0), expected[i][0], 0);
        check_close(piecewise(&packed_weights(&sources)[first], count, 1), expected[i][curves[i].weight_count - 1], 1e-6);
    }
    ew_sources_destroy(&sources, &ew_default_allocator);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_are_the_recursive_spline),  cmocka_unit_test(the_papers_example_has_its_values),
        cmocka_unit_test(even_weights_are_even_everywhere), cmocka_unit_test(one_weight_is_a_constant_and_two_are_a_ramp),
        cmocka_unit_test(each_curve_finds_its_own_pieces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
