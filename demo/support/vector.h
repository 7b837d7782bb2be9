/*
 * Vectors and points of three doubles, since floats are too coarse far from the world's origin.
 */
#ifndef VECTOR_H
#define VECTOR_H

#include <math.h>
#include <stdbool.h>

static inline void vector_copy(const double a[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i];
}

static inline void vector_subtract(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] - b[i];
}

/* result = a + s b */
static inline void vector_add_scaled(const double a[3], double s, const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] + s * b[i];
}

static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* `result` must be neither `a` nor `b`. */
static inline void vector_cross(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static inline double vector_length(const double a[3])
{
    return sqrt(vector_dot(a, a));
}

/* Brings `a` to unit length. Returns false, and a result of zero, if `a` is zero. Divides by the largest component first, so
 * that squares neither overflow nor underflow. */
static inline bool vector_normalize(const double a[3], double result[3])
{
    double largest = fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
    bool has_direction = largest > 0;
    for (int i = 0; i < 3; i++)
        result[i] = has_direction ? a[i] / largest : 0;
    double length = has_direction ? vector_length(result) : 1;
    for (int i = 0; i < 3; i++)
        result[i] /= length;
    return has_direction;
}

/* Two unit vectors across the unit vector `axis`, which with it are right-handed: u, v, axis. */
static inline void vector_across(const double axis[3], double u[3], double v[3])
{
    double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0};
    vector_cross(other, axis, u);
    vector_normalize(u, u);
    vector_cross(axis, u, v);
}

#endif
