/* The nearest point of an arc: see reference_arc.h. */
#include "reference_arc.h"
#include "vector.h"

/* Which piece of an arc the nearest point is on. The nearest point of a whole parabola leaps only across the plane of
 * symmetry, so that where it leaps, or becomes an end, the piece changes. */
enum { FIRST_END, LAST_END, BEFORE_VERTEX, BEHIND_VERTEX };

/* Half the derivative of the squared distance between C(t) and a point, by t. */
static double slope_at(const ew_curve *curve, const double from[3], double t)
{
    double slope = 0;
    for (int i = 0; i < 3; i++) {
        double c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i];
        slope += (from[i] + t * (c1 + t * c2)) * (c1 + 2 * t * c2);
    }
    return slope;
}

/* The root of slope_at between low, where it is negative, and high, where it is positive: Newton's method, kept within the
 * bracket by bisection. */
static double stationary_point(const ew_curve *curve, const double from[3], double low, double high)
{
    const double *c1 = curve->polynomial[1], *c2 = curve->polynomial[2];
    double t = 0.5 * (low + high), smallest_step = 2.3e-16 * (fabs(curve->domain[0]) + fabs(curve->domain[1]));
    double step = high - low;
    for (int i = 0; i < 200; i++) {
        double slope = slope_at(curve, from, t);
        if (slope == 0) return t;
        if (slope < 0)
            low = t;
        else
            high = t;
        double derivative =
            vector_dot(c1, c1) + 2 * vector_dot(c2, from) + 6 * t * (vector_dot(c1, c2) + t * vector_dot(c2, c2));
        double next = t - slope / derivative;
        if (!(next > low && next < high && 2 * fabs(next - t) < fabs(step))) next = 0.5 * (low + high);
        step = next - t;
        t = next;
        if (fabs(step) <= smallest_step) return t;
    }
    return t;
}

/* The ends of the arc and between them the critical points of the cubic whose roots are the stationary points: from one to the
 * next it is monotone. Returns how many. */
static int find_brackets(const ew_curve *curve, const double from[3], double edges[4])
{
    const double *c1 = curve->polynomial[1], *c2 = curve->polynomial[2];
    double first = curve->domain[0], last = curve->domain[1];
    int count = 0;
    edges[count++] = first;
    double a = 3 * vector_dot(c2, c2), b = 3 * vector_dot(c1, c2), c = 0.5 * vector_dot(c1, c1) + vector_dot(c2, from);
    double discriminant = b * b - 4 * a * c;
    if (discriminant > 0 && a > 0) {
        double q = -0.5 * (b + copysign(sqrt(discriminant), b));
        double low = fmin(q / a, c / q), high = fmax(q / a, c / q);
        if (low > first && low < last) edges[count++] = low;
        if (high > first && high < last) edges[count++] = high;
    }
    edges[count++] = last;
    return count;
}

/* The ends and the stationary points at which the distance is least. Returns how many. */
static int find_candidates(const ew_curve *curve, const double from[3], double candidates[5])
{
    double edges[4];
    int edge_count = find_brackets(curve, from, edges), count = 0;
    candidates[count++] = edges[0];
    double slope = slope_at(curve, from, edges[0]);
    for (int i = 0; i + 1 < edge_count; i++) {
        double next_slope = slope_at(curve, from, edges[i + 1]);
        if (slope < 0 && next_slope > 0) candidates[count++] = stationary_point(curve, from, edges[i], edges[i + 1]);
        slope = next_slope;
    }
    candidates[count++] = edges[edge_count - 1];
    return count;
}

nearest_point reference_nearest_of_arc(const ew_curve *curve, const double from[3])
{
    const double *c1 = curve->polynomial[1], *c2 = curve->polynomial[2];
    double candidates[5], least_square = HUGE_VAL;
    int count = find_candidates(curve, from, candidates);
    nearest_point best = {.distance = HUGE_VAL};
    for (int i = 0; i < count; i++) {
        double offset[3], t = candidates[i];
        for (int k = 0; k < 3; k++)
            offset[k] = -(from[k] + t * (c1[k] + t * c2[k]));
        double square = vector_dot(offset, offset);
        /* Of points that are all but equally near, the first, so that an arc that runs back on itself does not flicker. */
        if (square >= least_square * (1 - 1e-13)) continue;
        least_square = square;
        best.t = t;
        vector_copy(offset, best.offset);
    }
    best.distance = sqrt(least_square);
    best.piece = best.t <= curve->domain[0]                                 ? FIRST_END
                 : best.t >= curve->domain[1]                               ? LAST_END
                 : 2 * vector_dot(c2, c2) * best.t + vector_dot(c1, c2) < 0 ? BEFORE_VERTEX
                                                                            : BEHIND_VERTEX;
    return best;
}

double reference_curve_distance(const ew_curve *curve, const double point[3], double *t)
{
    double from[3];
    vector_subtract(curve->polynomial[0], point, from);
    nearest_point result = reference_nearest_of_arc(curve, from);
    if (t) *t = result.t;
    return result.distance;
}
