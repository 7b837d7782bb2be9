/* Vectors: see vector.h. */
#include "model/vector.h"

/* Scales first: the square of a length in range can be out of range. */
bool ew_normalize(const double v[3], double unit[3])
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
