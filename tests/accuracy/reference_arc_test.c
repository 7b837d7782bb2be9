/*
 * The reference's distances to curves against brute force in extended precision.
 */
#include "brute_force.h"
#include "reference_arc.h"
#include "reference_cases.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void distances_to_curves_match_brute_force(void **state)
{
    (void)state;
    uint64_t random = 1;
    for (int i = 0; i < 4000; i++) {
        ew_curve curve = random_curve(&random, i % CURVE_SHAPES);
        double point[3], t;
        random_vector(&random, 3, point);
        const long double p[3] = {point[0], point[1], point[2]};
        long double brute_force_t = 0;
        double truth = (double)brute_force_curve_distance(&curve, p, &brute_force_t);
        double distance = reference_curve_distance(&curve, point, &t);
        if (fabs(distance - truth) > 1e-14 * (10 + truth)) fail_msg("case %d: %.17g, by brute force %.17g", i, distance, truth);
        assert_true(fabs((double)sqrtl(brute_force_square_distance_at(&curve, p, t)) - distance) < 1e-14 * (10 + truth));
        assert_true(t >= curve.domain[0] && t <= curve.domain[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(distances_to_curves_match_brute_force)};
    return cmocka_run_group_tests_name("reference distances", tests, NULL, NULL);
}
