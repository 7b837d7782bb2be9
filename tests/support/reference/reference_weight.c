/* Weights by their definition: see reference_weight.h. */
#include "reference_weight.h"

#include <math.h>

/* Knot i of (16) for n weights: 0, 0, 0, 1/(n-2), ..., (n-3)/(n-2), 1, 1, 1. */
static double knot(int i, int n)
{
    return i <= 2 ? 0 : i >= n ? 1 : (i - 2) / (double)(n - 2);
}

/* N_i^degree(u): (14), where 0/0 counts as 0. */
static double basis(int i, int degree, int n, double u)
{
    double first = knot(i, n), last = knot(i + degree + 1, n);
    if (degree == 0) return (first <= u && u < last) || (u == 1 && first < 1 && last == 1) ? 1 : 0;
    double rise = knot(i + degree, n) - first, fall = last - knot(i + 1, n);
    return (rise > 0 ? (u - first) / rise * basis(i, degree - 1, n, u) : 0) +
           (fall > 0 ? (last - u) / fall * basis(i + 1, degree - 1, n, u) : 0);
}

int reference_weight_span(size_t count, double u)
{
    if (count < 4) return 0;
    int last = (int)count - 3, span = (int)floor(u * (double)(count - 2));
    if (span > last) span = last;
    while (span > 0 && u < knot(span + 2, (int)count))
        span--;
    while (span < last && u >= knot(span + 3, (int)count))
        span++;
    return span;
}

double reference_weight(const double *weights, size_t count, double u)
{
    if (count == 0) return 1;
    if (count == 1) return weights[0];
    if (count == 2) return (1 - u) * weights[0] + u * weights[1];
    double sum = 0;
    int span = reference_weight_span(count, u);
    for (int i = span; i < span + 3; i++)
        sum += weights[i] * basis(i, 2, (int)count, u);
    return sum;
}
