/* Cubic and quadratic curves: see spline.h. */
#include "model/spline.h"

#include "model/vector.h"

/* The Bezier points b0, b1, b2 have the polynomial b0, 2 (b1 - b0), b0 - 2 b1 + b2: with chord = b2 - b0 and bend the last of
 * these, the middle one is chord - bend. */
ew_quadratic ew_quadratic_from_chord(const double start[3], const double chord[3], const double bend[3])
{
    ew_quadratic made;
    for (int i = 0; i < 3; ++i) {
        made.polynomial[0][i] = start[i];
        made.polynomial[1][i] = chord[i] - bend[i];
        made.polynomial[2][i] = bend[i];
    }
    return made;
}

/* A cubic less the quadratic below is (P3 - 3 P2 + 3 P1 - P0) u (1 - u) (1 - 2 u) / 2, whose largest factor is sqrt(3) / 36.
 * One of m equal parts has the m^3-th part of that. */
double ew_cubic_part_count(const ew_cubic *cubic, double tolerance)
{
    const double(*p)[3] = cubic->points;
    double third_difference[3];
    for (int i = 0; i < 3; ++i)
        third_difference[i] = (p[3][i] - p[0][i]) - 3 * (p[2][i] - p[1][i]);
    double distance = sqrt(3) / 36 * sqrt(ew_dot(third_difference, third_difference));
    double count = ceil(cbrt(distance / tolerance));
    return count < 1 ? 1 : count;
}

/* Exact at both ends, so that neighbours meet to the last bit. */
static double mix(double a, double b, double u)
{
    return (1 - u) * a + u * b;
}

/* Place and derivative by de Casteljau. */
static void evaluate(const ew_cubic *cubic, double u, double place[3], double derivative[3])
{
    const double(*p)[3] = cubic->points;
    for (int i = 0; i < 3; ++i) {
        double middle = mix(p[1][i], p[2][i], u);
        double before = mix(mix(p[0][i], p[1][i], u), middle, u);
        double after = mix(middle, mix(p[2][i], p[3][i], u), u);
        place[i] = mix(before, after, u);
        derivative[i] = 3 * (after - before);
    }
}

/* A part with the Bezier points Q has (3 Q1 + 3 Q2 - Q0 - Q3) / 4 for its control point. By Q1 = Q0 + h C'(start) / 3 and Q2 =
 * Q3 - h C'(end) / 3, with h = end - start, that makes the bend h (C'(end) - C'(start)) / 2. */
ew_quadratic ew_cubic_part(const ew_cubic *cubic, double start, double end)
{
    double places[2][3], derivatives[2][3], chord[3], bend[3];
    evaluate(cubic, start, places[0], derivatives[0]);
    evaluate(cubic, end, places[1], derivatives[1]);
    for (int i = 0; i < 3; ++i) {
        chord[i] = places[1][i] - places[0][i];
        bend[i] = (end - start) * (derivatives[1][i] - derivatives[0][i]) / 2;
    }
    return ew_quadratic_from_chord(places[0], chord, bend);
}

/* C(u) = start + u chord - u (1 - u) bend: a bend across the chord takes the curve a quarter of its length away, and one along
 * the chord turns it back if it is longer than the chord. */
bool ew_quadratic_is_straight(const ew_quadratic *quadratic, double tolerance)
{
    const double *bend = quadratic->polynomial[2];
    double chord[3], across[3];
    for (int i = 0; i < 3; ++i)
        chord[i] = quadratic->polynomial[1][i] + bend[i];
    double length2 = ew_dot(chord, chord);
    if (!(length2 > 0)) return false;
    double along = ew_dot(bend, chord) / length2;
    for (int i = 0; i < 3; ++i)
        across[i] = bend[i] - along * chord[i];
    const double rounding = 1e-9;
    return fabs(along) <= 1 + rounding && sqrt(ew_dot(across, across)) / 4 <= tolerance;
}

/* |C(u) - start| <= |C1| + |C2|. */
bool ew_quadratic_is_point(const ew_quadratic *quadratic, double tolerance)
{
    const double *tangent = quadratic->polynomial[1], *bend = quadratic->polynomial[2];
    return sqrt(ew_dot(tangent, tangent)) + sqrt(ew_dot(bend, bend)) <= tolerance;
}
