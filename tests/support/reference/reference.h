/*
 * The reference: the luminance of a field along one ray, in double precision, as accurate as is practical. It evaluates the
 * definition in energywave.h directly (distance to the nearest point, recursive B-spline basis) under adaptive Gauss-Kronrod
 * quadrature, and shares neither code nor method with the library and its shaders.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "energywave.h"
#include <stdbool.h>

/* A reference value counts as reliable while its error is at most this share of it. */
#define REFERENCE_RELATIVE_ERROR 1e-7

/* A body of a medium on a ray, from one s to another. */
typedef struct reference_body {
    double extinction; /* per world unit */
    double from, to;
} reference_body;

/* Fog along a ray, of which light at s leaves exp(-optical depth from `begin` to s). */
typedef struct reference_fog {
    double extinction;                   /* per world unit; 0: none */
    double begin;                        /* s, at most 0 */
    bool has_height;                     /* then the extinction is that times exp(-height) */
    double height[2];                    /* over the fog's base, in its scale, at s = 0 and at s = 1 */
    reference_body bodies[EW_MAX_MEDIA]; /* which dim the light as well */
    size_t body_count;
} reference_fog;

/* L(s) = start + s (end - start), s from 0 to s_max, in the sources' space. Coordinates near the origin keep the most digits:
 * for a camera far from it, move sources and ray so that the eye is at the origin.
 *
 * In the papers' integral, start and end are S and E, and s_max <= 1. In the world integral, start is the eye, or the near
 * plane of a parallel projection; end is any other point of the ray; and s_max may be HUGE_VAL. */
typedef struct reference_ray {
    double start[3];
    double end[3];
    double s_max;
    bool is_world;
    double decay_alpha; /* of the papers' integral, as beta */
    double decay_beta;
    reference_fog fog;
    double least_core[2]; /* half of `core_pixels` pixels, in world units, at s = 0 and at s = 1 */
} reference_ray;

/* A luminance and a bound of its absolute error. */
typedef struct reference_value {
    double luminance;
    double error;
} reference_value;

/* Memory to compute in. One thread at a time. */
typedef struct reference_workspace reference_workspace;

/* NULL if memory is exhausted. Turns GSL's error handler off, for the whole process. */
reference_workspace *reference_create_workspace(void);
void reference_destroy_workspace(reference_workspace *workspace);

/* Computes the luminance of the sources together, and in `shares` (NULL for none) that of each source, kind by kind in the
 * order of source_kinds.h. Returns whether the sum's error is within REFERENCE_RELATIVE_ERROR. In the world integral each
 * source has a reach; where a line runs along the ray and nothing ends its light, the error is infinite. */
bool reference_luminance(reference_workspace *workspace, const ew_sources_desc *sources, const reference_ray *ray,
                         reference_value *sum, reference_value *shares);

#endif
