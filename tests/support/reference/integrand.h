/*
 * The integrand of one source along one ray: its value, and what the search for break points must know about it.
 */
#ifndef INTEGRAND_H
#define INTEGRAND_H

#include "reference.h"
#include "source_kind.h"

/* Positions on the ray are measured by x = s - origin_s, places from L(origin_s): near the narrowest peak, they keep the digits
 * that s would lose. What they are differences of is kept in extended precision for the same reason. */
typedef struct integrand {
    reference_source source;
    double coefficient;
    double direction[3]; /* E - S */
    long double position_from_start[3];
    long double exact_axis[3];
    long double exact_direction[3];
    double origin_s;
    bool is_world;
    double alpha, beta;      /* of the papers' integral */
    double core, reach;      /* HUGE_VAL for no reach */
    double least_core;       /* at the start of the ray, */
    double least_core_slope; /* and by how much it grows with s */
    reference_fog fog;
} integrand;

/* What of a source does not follow from its kind. */
typedef struct integrand_light {
    double coefficient;
    double core;
    double reach; /* HUGE_VAL for none */
} integrand_light;

typedef struct integrand_sample {
    double x;
    double slope;    /* sign of the derivative of the distance by x; 0 where that may be noise */
    double distance; /* not below the core's radius */
    double value;    /* of the integrand */
    double most;     /* what the value would be with the source's largest weight */
    bool is_dark;    /* beyond the reach */
    int label;       /* changes at every kink and jump */
} integrand_sample;

/* The origin is where the ray starts. */
integrand integrand_make(const source_kind *kind, const void *source, const integrand_light *light, const reference_ray *ray);
void integrand_set_origin(integrand *f, double origin_s);

/* Narrows the part of the ray from s = low to s = high to where the source's reach may extend. Returns false if nothing is
 * left. */
bool integrand_limit(const integrand *f, double *low, double *high);

/* Without fog and bodies. */
integrand_sample integrand_at(const integrand *f, double x);

/* The optical depth of fog and bodies from where the fog begins up to x. */
double integrand_optical_depth(const integrand *f, double x);

/* The derivative of the distance by x, times the distance. */
double integrand_distance_slope(const integrand *f, double x);

#endif
