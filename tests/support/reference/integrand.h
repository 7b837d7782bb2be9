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
    double alpha, beta, epsilon;
} integrand;

typedef struct integrand_sample {
    double x;
    double slope;    /* sign of the derivative of the distance by x; 0 where that may be noise */
    double distance; /* not below epsilon */
    double value;    /* of the integrand */
    double most;     /* what the value would be with the source's largest weight */
    int label;       /* changes at every kink and jump */
} integrand_sample;

/* The origin is where the ray starts. */
integrand integrand_make(const source_kind *kind, const void *source, const reference_ray *ray, double epsilon);
void integrand_set_origin(integrand *f, double origin_s);

integrand_sample integrand_at(const integrand *f, double x);

/* The derivative of the distance by x, times the distance. */
double integrand_distance_slope(const integrand *f, double x);

#endif
