/* The helpers that need no effect: a Bezier's polynomial, the travelling pulse, the texts of results. */
#include "check.h"

static const double pi = 3.14159265358979323846;

static void a_bezier_polynomial_is_the_curve_of_de_casteljau(void **state)
{
    (void)state;
    const double control_points[3][3] = {{1, -2, 3}, {4.5, 0, -7}, {-1, 8, 0.25}};
    double polynomial[3][3];
    ew_bezier_polynomial(control_points[0], control_points[1], control_points[2], polynomial);
    for (int step = 0; step <= 10; ++step) {
        double t = step / 10.0;
        for (int i = 0; i < 3; ++i) {
            double first = control_points[0][i] + t * (control_points[1][i] - control_points[0][i]);
            double second = control_points[1][i] + t * (control_points[2][i] - control_points[1][i]);
            double point = first + t * (second - first);
            check_close(polynomial[0][i] + t * (polynomial[1][i] + t * polynomial[2][i]), point, 1e-14);
        }
    }
}

static void control_points_at_even_distances_make_a_straight_polynomial(void **state)
{
    (void)state;
    double control_points[3][3] = {{100000.1, 0.5, 7}, {100000.2, 0.5, 8}, {100000.3, 0.5, 9}};
    double polynomial[3][3];
    ew_bezier_polynomial(control_points[0], control_points[1], control_points[2], polynomial);
    check_close(polynomial[2][0], 0, 1e-10); /* what doubles at 1e5 leave */
    assert_true(polynomial[2][1] == 0 && polynomial[2][2] == 0);
}

/* Thesis (5.1), as printed. */
static double pulse_weight(double t, int i)
{
    double theta = (t - 7 * i) / 25 * pi;
    double clamped = 0 <= theta && theta <= 2 * pi ? theta : 0;
    double w = (-cos(clamped) + 0.8) / 1.5;
    return w < 0 ? 0 : w > 1 ? 1 : w;
}

static void the_pulse_is_that_of_the_thesis(void **state)
{
    (void)state;
    double weights[9];
    for (double frame = -20; frame <= 130; frame += 0.5) {
        ew_fill_pulse_weights(frame, weights, 9);
        for (int i = 0; i < 9; ++i)
            check_close(weights[i], pulse_weight(frame, i), 1e-14);
    }
}

static void the_pulse_wakes_peaks_and_is_dark_again_when_the_header_says(void **state)
{
    (void)state;
    double weights[8];
    for (int i = 0; i < 8; ++i) {
        double wake = 7 * i;
        ew_fill_pulse_weights(wake, weights, 8);
        assert_true(weights[i] == 0);
        ew_fill_pulse_weights(wake + 25, weights, 8);
        assert_true(weights[i] == 1);
        ew_fill_pulse_weights(wake + 50, weights, 8);
        assert_true(weights[i] == 0);
        ew_fill_pulse_weights(wake + 12.5, weights, 8); /* on its way up */
        check_close(weights[i], 0.8 / 1.5, 1e-14);
    }
}

static void the_pulse_takes_any_frame_and_no_weights(void **state)
{
    (void)state;
    const double frames[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e300};
    for (size_t i = 0; i < sizeof frames / sizeof frames[0]; ++i) {
        double weights[3] = {7, 7, 7};
        ew_fill_pulse_weights(frames[i], weights, 2);
        assert_true(weights[0] == 0 && weights[1] == 0);
        assert_true(weights[2] == 7); /* beyond the count */
    }
    ew_fill_pulse_weights(0, NULL, 3);
}

static void every_result_has_a_text_of_its_own(void **state)
{
    (void)state;
    const ew_result results[] = {
#define RESULT(name, text) name,
        EW_RESULTS(RESULT)
#undef RESULT
    };
    const size_t count = sizeof results / sizeof results[0];
    for (size_t i = 0; i < count; ++i) {
        assert_true(strlen(ew_result_text(results[i])) > 0);
        for (size_t j = 0; j < i; ++j)
            assert_string_not_equal(ew_result_text(results[i]), ew_result_text(results[j]));
    }
    assert_non_null(ew_result_text((ew_result)count));
    assert_non_null(ew_result_text((ew_result)-1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bezier_polynomial_is_the_curve_of_de_casteljau),
        cmocka_unit_test(control_points_at_even_distances_make_a_straight_polynomial),
        cmocka_unit_test(the_pulse_is_that_of_the_thesis),
        cmocka_unit_test(the_pulse_wakes_peaks_and_is_dark_again_when_the_header_says),
        cmocka_unit_test(the_pulse_takes_any_frame_and_no_weights),
        cmocka_unit_test(every_result_has_a_text_of_its_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
