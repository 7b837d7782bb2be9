/* Vectors: see vector.h. */
#include "model/vector.h"

static void divide(const double v[3], double length, double out[3])
{
    for (int i = 0; i < 3; ++i)
        out[i] = v[i] / length;
}

/* The square of a length in range can be out of range: then it is scaled first. */
bool ew_normalize(const double v[3], double unit[3])
{
    double square = ew_dot(v, v);
    if (square > 1e-200 && square < 1e200) {
        divide(v, sqrt(square), unit);
        return true;
    }
    double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (largest == 0) return false;
    divide(v, largest, unit);
    divide(unit, sqrt(ew_dot(unit, unit)), unit);
    return true;
}

void ew_perpendicular(const double v[3], double unit[3])
{
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (fabs(v[i]) < fabs(v[least])) least = i;
    double across[3];
    for (int i = 0; i < 3; ++i)
        across[i] = (i == least ? 1 : 0) - v[least] * v[i];
    ew_normalize(across, unit);
}
