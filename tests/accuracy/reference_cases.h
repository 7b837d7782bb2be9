/*
 * Random cases for the reference: rays, curves of every shape, and places near the rays. The same in every run. And what the
 * tests of the reference do with them.
 */
#ifndef REFERENCE_CASES_H
#define REFERENCE_CASES_H

#include "energywave.h"
#include "reference.h"

#include <stdint.h>

enum { CURVE_SHAPES = 20 };

double log_uniform(uint64_t *random, double low, double high);
void random_vector(uint64_t *random, double scale, double v[3]);

/* Of one of CURVE_SHAPES shapes, the degenerate ones among them. */
ew_curve random_curve(uint64_t *random, int shape);

/* Whether more than one point of such a curve is nearest, or so nearly that rounding decides: where it runs back over itself,
 * or is a point. Which weight counts there is undefined. */
bool curve_is_ambiguous(int shape);

reference_ray random_ray(uint64_t *random, double longest);

/* A point that the ray passes at a distance of about `miss`. */
void point_near_ray(uint64_t *random, const reference_ray *ray, double miss, double point[3]);

/* ---- For cmocka's tests -------------------------------------------------------------------------------------------------- */

/* Of the group of tests whose fixture these are. */
extern reference_workspace *workspace;
int create_workspace(void **state);
int destroy_workspace(void **state);

/* Fails the test where the reference does not vouch for the value. */
reference_value value_of(const ew_sources_desc *sources, const reference_ray *ray);

/* Within `tolerance` of the larger of truth and floor. */
void assert_close(double value, double truth, double tolerance, double floor);

/* `coefficient` allows for fields with that one of which the ray meets next to nothing; 0 for others. */
void assert_matches_brute_force(const ew_sources_desc *sources, const reference_ray *ray, double coefficient, const char *what,
                                int number);

#endif
