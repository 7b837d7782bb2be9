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

/* Writes the unit vector along `v`. Returns false for a vector without direction, and leaves `unit` alone. */
bool ew_normalize(const double v[3], double unit[3]);

/* Writes a unit vector across the unit vector `v`, close to the coordinate axis that is most so. */
void ew_perpendicular(const double v[3], double unit[3]);

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
