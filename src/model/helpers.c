/* The helpers that need no effect: a Bezier's polynomial and the travelling pulse. */
#include "energywave.h"

#include <math.h>

void ew_bezier_polynomial(const double start[3], const double middle[3], const double end[3], double polynomial[3][3])
{
    for (int i = 0; i < 3; ++i) {
        polynomial[0][i] = start[i];
        polynomial[1][i] = 2 * (middle[i] - start[i]);
        polynomial[2][i] = (end[i] - middle[i]) - (middle[i] - start[i]);
    }
}

void ew_fill_pulse_weights(double frame, double *weights, size_t count)
{
    const double pi = 3.14159265358979323846;
    for (size_t i = 0; weights && i < count; ++i) {
        double theta = (frame - 7.0 * (double)i) / 25.0 * pi;
        if (!(theta >= 0 && theta <= 2 * pi)) theta = 0;
        weights[i] = fmin(1, fmax(0, (0.8 - cos(theta)) / 1.5));
    }
}
