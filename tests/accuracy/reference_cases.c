/* Random cases for the reference: see reference_cases.h. */
#include "reference_cases.h"
#include "brute_force.h"
#include "random_numbers.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

double log_uniform(uint64_t *random, double low, double high)
{
    return exp(random_between(random, log(low), log(high)));
}

void random_vector(uint64_t *random, double scale, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = random_between(random, -scale, scale);
}

ew_curve random_curve(uint64_t *random, int shape)
{
    ew_curve curve = {.domain = {0, 1}, .coefficient = 1};
    double points[3][3];
    for (int i = 0; i < 3; i++)
        random_vector(random, 2, points[i]);
    double bend = (const double[]){1, 1e-2, 1e-4, 1e-7, 0}[shape % 5];
    if (shape >= 5 && shape < 10) /* nearly or exactly straight */
        for (int i = 0; i < 3; i++)
            points[1][i] = 0.5 * (points[0][i] + points[2][i]) + bend * (points[1][i] - points[0][i]);
    if (shape >= 10 && shape < 15) /* collinear, folded back, or a narrow hairpin */
        for (int i = 0; i < 3; i++)
            points[1][i] = points[0][i] + 1.5 * (points[2][i] - points[0][i]) + 1e-2 * bend * points[1][i];
    if (shape == 15) memcpy(points[1], points[0], sizeof points[1]);
    if (shape == 16) memcpy(points[1], points[2], sizeof points[1]);
    if (shape == 17) memcpy(points[2], points[0], sizeof points[2]);
    if (shape == 18) memcpy(points[1], points[0], sizeof points[1]), memcpy(points[2], points[0], sizeof points[2]);
    for (int i = 0; i < 3; i++) {
        curve.polynomial[0][i] = points[0][i];
        curve.polynomial[1][i] = 2 * (points[1][i] - points[0][i]);
        curve.polynomial[2][i] = points[0][i] - 2 * points[1][i] + points[2][i];
    }
    if (shape == 19) curve.domain[0] = -2, curve.domain[1] = 1.5;
    return curve;
}

reference_ray random_ray(uint64_t *random, double longest)
{
    reference_ray ray = {.s_max = random_between(random, 0, 2) > 1 ? 1 : random_between(random, 0.1, 1),
                         .decay_alpha = random_between(random, 0.5, 2)};
    ray.decay_beta = log_uniform(random, 0.05, 4);
    double direction[3];
    random_vector(random, 3, ray.start);
    random_vector(random, 1, direction);
    double ray_length = log_uniform(random, 3, longest);
    for (int i = 0; i < 3; i++)
        ray.end[i] = ray.start[i] + ray_length * direction[i];
    return ray;
}

void point_near_ray(uint64_t *random, const reference_ray *ray, double miss, double point[3])
{
    double away[3], ray_length = 0;
    random_vector(random, 1, away);
    for (int i = 0; i < 3; i++)
        ray_length += fabs(ray->end[i] - ray->start[i]);
    double s = fmin(1, 3 / ray_length) * random_between(random, 0, 1);
    for (int i = 0; i < 3; i++)
        point[i] = ray->start[i] + s * (ray->end[i] - ray->start[i]) + miss * away[i];
}

bool curve_is_ambiguous(int shape)
{
    return shape == 13 || shape == 14 || shape == 17 || shape == 18;
}

/* ---- For cmocka's tests -------------------------------------------------------------------------------------------------- */

reference_workspace *workspace;

int create_workspace(void **state)
{
    (void)state;
    return (workspace = reference_create_workspace()) ? 0 : -1;
}

int destroy_workspace(void **state)
{
    (void)state;
    reference_destroy_workspace(workspace);
    return 0;
}

reference_value value_of(const ew_sources_desc *sources, const reference_ray *ray)
{
    reference_value value;
    if (!reference_luminance(workspace, sources, ray, &value, NULL))
        fail_msg("the reference does not vouch for %g +- %g", value.luminance, value.error);
    return value;
}

void assert_close(double value, double truth, double tolerance, double floor)
{
    if (!(fabs(value - truth) <= tolerance * fmax(truth, floor))) fail_msg("%.12g is not %.12g", value, truth);
}

void assert_matches_brute_force(const ew_sources_desc *sources, const reference_ray *ray, double coefficient, const char *what,
                                int number)
{
    reference_value value = value_of(sources, ray);
    double truth = brute_force_luminance(sources, ray), error = fabs(value.luminance - truth);
    if (error > value.error + BRUTE_FORCE_ERROR * truth + BRUTE_FORCE_DARK_ERROR * coefficient)
        fail_msg("%s %d: %.12g +- %.1e, by brute force %.12g", what, number, value.luminance, value.error, truth);
}
