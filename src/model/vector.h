/* Vectors of three doubles, and column-major matrices. */
#ifndef EW_VECTOR_H
#define EW_VECTOR_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

static inline double ew_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void ew_cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; ++i)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Scales first: the square of a length in range can be out of range. Returns false for a vector without direction. */
static inline bool ew_normalize(const double v[3], double unit[3])
{
    double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (largest == 0) return false;
    for (int i = 0; i < 3; ++i)
        unit[i] = v[i] / largest;
    double length = sqrt(ew_dot(unit, unit));
    for (int i = 0; i < 3; ++i)
        unit[i] /= length;
    return true;
}

/* A unit vector across `v`, close to the coordinate axis that is most so. */
static inline void ew_perpendicular(const double v[3], double unit[3])
{
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (fabs(v[i]) < fabs(v[least])) least = i;
    double across[3];
    for (int i = 0; i < 3; ++i)
        across[i] = (i == least ? 1 : 0) - v[least] * v[i];
    ew_normalize(across, unit);
}

static inline bool ew_all_finite(const double *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(values[i])) return false;
    return true;
}

static inline double ew_element(const double matrix[16], int row, int column)
{
    return matrix[4 * column + row];
}

#endif
