/* A path's field by brute force: see brute_force_path.h. */
#include "brute_force_path.h"

#include <math.h>

static long double distance_to(const long double p[3], const long double place[3])
{
    return hypotl(hypotl(p[0] - place[0], p[1] - place[1]), p[2] - place[2]);
}

static size_t piece_count(const ew_path *path)
{
    return path->point_count - (path->is_closed ? 0 : path->kind == EW_PATH_BSPLINE ? 2 : 1);
}

/* The share of the way from a to b that is nearest to p. */
static long double nearest_of_segment(const double a[3], const double b[3], const long double p[3])
{
    long double along = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        long double way = (long double)b[i] - a[i];
        along += way * (p[i] - a[i]);
        square += way * way;
    }
    return square > 0 ? fminl(1, fmaxl(0, along / square)) : 0;
}

static long double polyline_piece(const ew_path *path, size_t piece, const long double p[3], long double *t, long double end[3])
{
    const double *a = path->points[piece], *b = path->points[(piece + 1) % path->point_count];
    long double place[3];
    *t = nearest_of_segment(a, b, p);
    for (int i = 0; i < 3; i++) {
        place[i] = a[i] + *t * ((long double)b[i] - a[i]);
        end[i] = b[i];
    }
    return distance_to(p, place);
}

/* A piece of a uniform quadratic B-spline: with knots doubled at the ends of an open one, its de Boor points are the middles
 * of the control polygon's sides, or its ends. */
static long double bspline_piece(const ew_path *path, size_t piece, const long double p[3], long double *t, long double end[3])
{
    size_t n = path->point_count, middle = piece + !path->is_closed;
    const double *before = path->points[(middle + n - 1) % n], *at = path->points[middle % n];
    const double *after = path->points[(middle + 1) % n];
    bool is_first = !path->is_closed && piece == 0, is_last = !path->is_closed && piece + 3 == n;
    ew_curve arc = {.domain = {0, 1}};
    for (int i = 0; i < 3; i++) {
        double from = is_first ? 2 * before[i] - at[i] : before[i], to = is_last ? 2 * after[i] - at[i] : after[i];
        arc.polynomial[0][i] = (from + at[i]) / 2;
        arc.polynomial[1][i] = at[i] - from;
        arc.polynomial[2][i] = (from - 2 * at[i] + to) / 2;
        end[i] = ((long double)at[i] + to) / 2;
    }
    return brute_force_curve_distance(&arc, p, t);
}

long double brute_force_path_field(const ew_path *path, const brute_force_light *light, const long double p[3])
{
    size_t count = piece_count(path);
    long double field = 0;
    for (size_t piece = 0; piece < count; piece++) {
        long double t = 0, end[3];
        long double distance =
            path->kind == EW_PATH_POLYLINE ? polyline_piece(path, piece, p, &t, end) : bspline_piece(path, piece, p, &t, end);
        bool is_last = piece + 1 == count;
        long double u = ((long double)piece + t) / (long double)count;
        long double end_u = is_last ? 0 : (long double)(piece + 1) / (long double)count;
        field += brute_force_weight(path->weights, path->weight_count, u) * brute_force_glow(light, distance);
        if (is_last && !path->is_closed) continue;
        long double weight = brute_force_weight(path->weights, path->weight_count, end_u);
        field -= weight * brute_force_glow(light, distance_to(p, end));
    }
    return field;
}
