/*
 * The reference's weights against what is known of B-splines, and against values computed by hand.
 */
#include "reference_weight.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void equal_weights_are_constant(void **state)
{
    (void)state;
    double weights[64];
    for (int i = 0; i < 64; i++)
        weights[i] = 0.7;
    for (size_t n = 1; n <= 64; n++)
        for (int i = 0; i <= 1000; i++)
            assert_true(fabs(reference_weight(weights, n, i / 1000.0) - 0.7) < 1e-15);
    assert_true(reference_weight(NULL, 0, 0.3) == 1);
}

/* A B-spline whose control values are its Greville abscissae (the means of the inner knots) is the identity. */
static void greville_abscissae_as_weights_give_the_identity(void **state)
{
    (void)state;
    for (int n = 3; n <= 64; n++) {
        double weights[64];
        for (int i = 0; i < n; i++) {
            double low = i >= 1 ? i - 1 : 0, high = i <= n - 2 ? i : n - 2;
            weights[i] = 0.5 * (low + high) / (n - 2);
        }
        for (int i = 0; i <= 1000; i++)
            assert_true(fabs(reference_weight(weights, (size_t)n, i / 1000.0) - i / 1000.0) < 1e-14);
    }
}

static void weights_match_values_computed_by_hand(void **state)
{
    (void)state;
    assert_true(reference_weight((double[]){0.25}, 1, 0.9) == 0.25);
    assert_true(fabs(reference_weight((double[]){1, 3}, 2, 0.25) - 1.5) < 1e-15);
    /* n = 3 is a Bezier: (w0 + 2 w1 + w2) / 4 in the middle. */
    assert_true(fabs(reference_weight((double[]){1, 2, 7}, 3, 0.5) - 3) < 1e-15);
    /* n = 4 has one inner knot, at 1/2: N0 = (1 - 2u)^2 = 1/4 and N2 = 2u^2 = 1/8 at u = 1/4; N1 is the rest. At the knot, N1
     * and N2 share evenly. */
    assert_true(fabs(reference_weight((double[]){8, 0, 0, 0}, 4, 0.25) - 2) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 8, 0, 0}, 4, 0.25) - 5) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 0, 8, 0}, 4, 0.25) - 1) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 0, 0, 8}, 4, 0.25) - 0) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 8, 0, 0}, 4, 0.5) - 4) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 0, 8, 0}, 4, 0.5) - 4) < 1e-15);
}

static void weights_start_and_end_at_the_first_and_last(void **state)
{
    (void)state;
    const double weights[] = {0.3, 0.9, 0.1, 0.5, 0.7};
    for (size_t n = 2; n <= 5; n++) {
        assert_true(reference_weight(weights, n, 0) == weights[0]);
        assert_true(reference_weight(weights, n, 1) == weights[n - 1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_weights_are_constant),
        cmocka_unit_test(greville_abscissae_as_weights_give_the_identity),
        cmocka_unit_test(weights_match_values_computed_by_hand),
        cmocka_unit_test(weights_start_and_end_at_the_first_and_last),
    };
    return cmocka_run_group_tests_name("reference weights", tests, NULL, NULL);
}
