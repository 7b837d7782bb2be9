/* Paths as chains of pieces, against each kind's own definition. */
#include "check.h"
#include "model/arc.h"
#include "model/path.h"
#include "model/vector.h"

#include <stdlib.h>

enum { MAX_POINTS = 40, SAMPLES = 400 };

static const double core = 0.05;
static const ew_source_name name = {"paths", 2};

/* A path with points of its own, and what it became. */
typedef struct made_path {
    double points[MAX_POINTS][3];
    ew_path path;
    ew_path_piece pieces[EW_MAX_PATH_PIECES];
    size_t count;
} made_path;

static void make_pieces(made_path *made)
{
    made->path.points = (const double(*)[3])made->points;
    assert_int_equal(ew_check_path(&made->path, &name, NULL), EW_OK);
    assert_int_equal(ew_count_path_pieces(&made->path, core, &name, &made->count, NULL), EW_OK);
    assert_in_range(made->count, 1, EW_MAX_PATH_PIECES);
    ew_make_path_pieces(&made->path, core, made->pieces);
}

static void make_random(made_path *made, ew_path_kind kind, size_t point_count, int is_closed)
{
    *made = (made_path){.path = {.kind = kind, .point_count = point_count, .is_closed = is_closed}};
    for (size_t k = 0; k < point_count; ++k)
        for (int i = 0; i < 3; ++i)
            made->points[k][i] = 6.0 * rand() / RAND_MAX - 3;
    make_pieces(made);
}

static double at(const ew_path_piece *piece, double u, int i)
{
    const double(*c)[3] = piece->curve.polynomial;
    return c[0][i] + u * (c[1][i] + u * c[2][i]);
}

static double chain_at(const made_path *made, double t, int i)
{
    size_t k = 0;
    while (k + 1 < made->count && made->pieces[k].domain[1] < t)
        ++k;
    const ew_path_piece *piece = &made->pieces[k];
    return at(piece, (t - piece->domain[0]) / (piece->domain[1] - piece->domain[0]), i);
}

/* ---- The definitions, each in one coordinate ---- */

typedef double definition(const made_path *made, double t, int i);

static double wrapped(const made_path *made, long k, int i)
{
    long n = (long)made->path.point_count;
    return made->points[(k + n) % n][i];
}

static long span_of(double t, size_t spans, double *u)
{
    long span = (long)(t * (double)spans);
    if (span == (long)spans) --span;
    *u = t * (double)spans - (double)span;
    return span;
}

static double polyline(const made_path *made, double t, int i)
{
    double u;
    long span = span_of(t, made->path.point_count - (made->path.is_closed ? 0 : 1), &u);
    return (1 - u) * wrapped(made, span, i) + u * wrapped(made, span + 1, i);
}

/* Cox and de Boor's recursion. Knot k is k, or clamped to [lowest, highest]. */
static double basis(long k, int degree, double x, double lowest, double highest)
{
    double a = fmin(fmax((double)k, lowest), highest), b = fmin(fmax((double)k + 1, lowest), highest);
    if (degree == 0) return (a <= x && x < b) || (a < b && b == highest && x == highest);
    double c = fmin(fmax((double)(k + degree), lowest), highest);
    double d = fmin(fmax((double)(k + degree + 1), lowest), highest);
    double left = c > a ? (x - a) / (c - a) * basis(k, degree - 1, x, lowest, highest) : 0;
    double right = d > b ? (d - x) / (d - b) * basis(k + 1, degree - 1, x, lowest, highest) : 0;
    return left + right;
}

/* The basis of point k begins at knot k - 2; the clamped spline's parameter runs over [0, n - 2]. */
static double bspline(const made_path *made, double t, int i)
{
    long n = (long)made->path.point_count;
    double sum = 0;
    for (long k = 0; k < n && !made->path.is_closed; ++k)
        sum += made->points[k][i] * basis(k - 2, 2, t * (double)(n - 2), 0, (double)(n - 2));
    for (long k = -1; k <= n && made->path.is_closed; ++k)
        sum += wrapped(made, k, i) * basis(k - 1, 2, t * (double)n, -10, 1000);
    return sum;
}

static double de_casteljau(const double points[4], double u)
{
    double p[4] = {points[0], points[1], points[2], points[3]};
    for (int degree = 3; degree > 0; --degree)
        for (int k = 0; k < degree; ++k)
            p[k] += u * (p[k + 1] - p[k]);
    return p[0];
}

static double bezier(const made_path *made, double t, int i)
{
    double u, p[4];
    long span = span_of(t, (made->path.point_count - 1) / 3, &u);
    for (int k = 0; k < 4; ++k)
        p[k] = made->points[3 * span + k][i];
    return de_casteljau(p, u);
}

static double catmull_rom(const made_path *made, double t, int i)
{
    double u, p[4];
    long n = (long)made->path.point_count;
    long span = span_of(t, (size_t)(made->path.is_closed ? n : n - 1), &u);
    for (int k = 0; k < 4; ++k)
        p[k] = wrapped(made, span + k - 1, i);
    if (!made->path.is_closed && span == 0) p[0] = 2 * p[1] - p[2];
    if (!made->path.is_closed && span == n - 2) p[3] = 2 * p[2] - p[1];
    return 0.5 * (2 * p[1] +
                  u * (p[2] - p[0] + u * (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3] + u * (3 * p[1] - p[0] - 3 * p[2] + p[3]))));
}

/* The largest distance from the definition at the same t. */
static double largest_distance(const made_path *made, definition *expected)
{
    double largest = 0;
    size_t steps = SAMPLES * made->path.point_count;
    for (size_t step = 0; step <= steps; ++step) {
        double sum = 0, t = (double)step / (double)steps;
        for (int i = 0; i < 3; ++i) {
            double off = chain_at(made, t, i) - expected(made, t, i);
            sum += off * off;
        }
        largest = fmax(largest, sqrt(sum));
    }
    return largest;
}

static void check_chain(const made_path *made)
{
    const ew_path_piece *pieces = made->pieces;
    size_t count = made->count;
    assert_true(pieces[0].domain[0] == 0 && pieces[count - 1].domain[1] == 1);
    assert_int_equal(pieces[0].starts_at_joint, made->path.is_closed);
    for (size_t k = 0; k < count; ++k) {
        bool is_last = k + 1 == count;
        assert_true(pieces[k].domain[0] < pieces[k].domain[1]);
        if (is_last && !made->path.is_closed) continue;
        const ew_path_piece *next = &pieces[is_last ? 0 : k + 1];
        assert_true(next->starts_at_joint);
        if (!is_last) assert_true(pieces[k].domain[1] == next->domain[0]);
        for (int i = 0; i < 3; ++i)
            check_close(at(&pieces[k], 1, i), next->curve.polynomial[0][i], 1e-14);
    }
}

static void check_kind(ew_path_kind kind, size_t point_count, int is_closed, definition *expected, double tolerance)
{
    made_path made;
    make_random(&made, kind, point_count, is_closed);
    check_close(largest_distance(&made, expected), 0, tolerance);
    check_chain(&made);
}

static void every_kind_follows_its_definition(void **state)
{
    (void)state;
    srand(1);
    for (size_t n = 2; n <= 12; ++n) {
        check_kind(EW_PATH_POLYLINE, n, 0, polyline, 1e-13);
        check_kind(EW_PATH_CATMULL_ROM, n, 0, catmull_rom, 3e-4 * core);
        check_kind(EW_PATH_BEZIER, 3 * (n - 1) + 1, 0, bezier, 3e-4 * core);
        if (n == 2) continue;
        check_kind(EW_PATH_POLYLINE, n, 1, polyline, 1e-13);
        check_kind(EW_PATH_CATMULL_ROM, n, 1, catmull_rom, 3e-4 * core);
        check_kind(EW_PATH_BSPLINE, n, 0, bspline, 1e-13);
        check_kind(EW_PATH_BSPLINE, n, 1, bspline, 1e-13);
    }
}

/* One piece less would leave the tolerance: the error falls with the cube of the count. */
static void cubics_have_no_more_pieces_than_they_need(void **state)
{
    (void)state;
    srand(2);
    for (int repeat = 0; repeat < 20; ++repeat) {
        made_path made;
        make_random(&made, EW_PATH_BEZIER, 4, 0);
        double fewer = (double)made.count / ((double)made.count - 1);
        assert_true(made.count > 1);
        assert_true(largest_distance(&made, bezier) * fewer * fewer * fewer > 0.99 * 3e-4 * core);
    }
}

/* Joints of quadratic pieces lie half way between the points, the ends at the first and the last. */
static void bspline_joins_half_way(void **state)
{
    (void)state;
    made_path made = {.points = {{0, 0, 0}, {2, 0, 0}, {2, 4, 0}, {0, 4, 6}},
                      .path = {.kind = EW_PATH_BSPLINE, .point_count = 4}};
    make_pieces(&made);
    assert_int_equal(made.count, 2);
    const double joint[3] = {2, 2, 0};
    for (int i = 0; i < 3; ++i) {
        check_close(at(&made.pieces[0], 0, i), made.points[0][i], 0);
        check_close(made.pieces[1].curve.polynomial[0][i], joint[i], 0);
        check_close(at(&made.pieces[1], 1, i), made.points[3][i], 0);
    }
    check_close(made.pieces[1].domain[0], 0.5, 0);
}

static void two_points_are_one_straight_piece(void **state)
{
    (void)state;
    for (int kind = EW_PATH_POLYLINE; kind <= EW_PATH_CATMULL_ROM; kind += EW_PATH_CATMULL_ROM) {
        made_path made = {.points = {{1e6, 0.1, 0}, {1e6 + 0.7, 0.3, 0}},
                          .path = {.kind = (ew_path_kind)kind, .point_count = 2}};
        make_pieces(&made);
        assert_int_equal(made.count, 1);
        assert_true(made.pieces[0].is_straight);
        assert_false(made.pieces[0].starts_at_joint);
    }
}

/* The three points of one quadratic piece, and whether it is straight. */
static void check_straight(const double middle[3], const double end[3], bool is_straight)
{
    made_path made = {
        .points = {{1, 1, 1}, {1 + middle[0], 1 + middle[1], 1 + middle[2]}, {1 + end[0], 1 + end[1], 1 + end[2]}},
        .path = {.kind = EW_PATH_BSPLINE, .point_count = 3}};
    make_pieces(&made);
    assert_int_equal(made.count, 1);
    assert_int_equal(made.pieces[0].is_straight, is_straight);
}

static void pieces_are_straight_if_collinear_and_in_order(void **state)
{
    (void)state;
    const double end[3] = {3, 2, 1}, start[3] = {0, 0, 0};
    check_straight((const double[3]){1.5, 1, 0.5}, end, true);
    check_straight((const double[3]){0.3, 0.2, 0.1}, end, true);
    check_straight(start, end, true);
    check_straight(end, end, true);
    check_straight((const double[3]){-0.3, -0.2, -0.1}, end, false);
    check_straight((const double[3]){3.3, 2.2, 1.1}, end, false);
    check_straight(end, start, false);
    check_straight((const double[3]){2, 0, 0}, (const double[3]){4, 0, 0}, true);
    check_straight((const double[3]){2, core / 600, 0}, (const double[3]){4, 0, 0}, true);
    check_straight((const double[3]){2, core / 400, 0}, (const double[3]){4, 0, 0}, false);
}

/* Pieces without length are left out, and those that stay keep their share of t. */
static void coincident_points_keep_the_shares(void **state)
{
    (void)state;
    made_path made = {.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}},
                      .path = {.kind = EW_PATH_POLYLINE, .point_count = 7}};
    make_pieces(&made);
    assert_int_equal(made.count, 2);
    check_close(made.pieces[0].domain[0], 1.0 / 6, 0);
    check_close(made.pieces[0].domain[1], 2.0 / 6, 0);
    check_close(made.pieces[1].domain[0], 4.0 / 6, 0);
    check_close(made.pieces[1].domain[1], 5.0 / 6, 0);
    assert_false(made.pieces[0].starts_at_joint);
    assert_true(made.pieces[1].starts_at_joint);
    made.path.is_closed = 1;
    make_pieces(&made);
    assert_int_equal(made.count, 3);
    check_close(made.pieces[2].domain[0], 6.0 / 7, 0);
    assert_true(made.pieces[0].starts_at_joint);
}

static void a_path_may_be_a_point(void **state)
{
    (void)state;
    for (int kind = EW_PATH_POLYLINE; kind <= EW_PATH_CATMULL_ROM; ++kind)
        for (int is_closed = 0; is_closed <= (kind != EW_PATH_BEZIER); ++is_closed) {
            made_path made = {.path = {.kind = (ew_path_kind)kind, .point_count = 7, .is_closed = is_closed}};
            for (int k = 0; k < 7; ++k)
                memcpy(made.points[k], (const double[3]){0.1, -1.7e5, 1.0 / 3}, sizeof made.points[k]);
            make_pieces(&made);
            assert_int_equal(made.count, 1);
            assert_true(made.pieces[0].is_straight);
            assert_false(made.pieces[0].starts_at_joint);
            check_close(made.pieces[0].domain[1] - made.pieces[0].domain[0], 1, 0);
            for (int i = 0; i < 3; ++i)
                check_close(at(&made.pieces[0], 1, i), made.points[0][i], 0);
        }
}

/* ---- What is refused ---- */

static void check_path_refused(ew_path path, ew_result code, const char *text)
{
    ew_error error = {EW_OK, ""};
    check_refused(ew_check_path(&path, &name, &error), &error, code, text);
    assert_int_equal(ew_check_path(&path, &name, NULL), code);
}

static void check_count_refused(ew_path_kind kind, size_t point_count, int is_closed, const char *text)
{
    double points[MAX_POINTS][3] = {{0}};
    ew_path path = {.kind = kind, .points = (const double(*)[3])points, .point_count = point_count, .is_closed = is_closed};
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, text);
}

static void wrong_counts_are_refused(void **state)
{
    (void)state;
    check_count_refused(EW_PATH_POLYLINE, 0, 0, "paths[2].points must be 2 or more");
    check_count_refused(EW_PATH_POLYLINE, 1, 0, "paths[2].points must be 2 or more");
    check_count_refused(EW_PATH_CATMULL_ROM, 1, 0, "paths[2].points must be 2 or more");
    check_count_refused(EW_PATH_POLYLINE, 2, 1, "paths[2].points must be 3 or more if is_closed");
    check_count_refused(EW_PATH_CATMULL_ROM, 2, 1, "paths[2].points must be 3 or more if is_closed");
    check_count_refused(EW_PATH_BSPLINE, 2, 0, "paths[2].points must be 3 or more for EW_PATH_BSPLINE");
    check_count_refused(EW_PATH_BSPLINE, 2, 1, "paths[2].points must be 3 or more for EW_PATH_BSPLINE");
    const size_t wrong[] = {0, 1, 2, 3, 5, 6, 8, 9};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; ++i)
        check_count_refused(EW_PATH_BEZIER, wrong[i], 0, "paths[2].points must be 3 n + 1 for EW_PATH_BEZIER");
}

static void wrong_members_are_refused(void **state)
{
    (void)state;
    double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {2, 3, 0}, {4, 5, 6}}, weights[3] = {1, -1, 1};
    const ew_path good = {.points = (const double(*)[3])points, .point_count = 4};
    ew_path path = good;
    path.kind = (ew_path_kind)(EW_PATH_CATMULL_ROM + 1);
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].kind");
    path.kind = (ew_path_kind)-1;
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].kind");
    path = good;
    path.points = NULL;
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].points must not be NULL");
    path = good;
    path.is_closed = 2;
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].is_closed must be 0 or 1");
    path.is_closed = 1;
    path.kind = EW_PATH_BEZIER;
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].is_closed must be 0 for EW_PATH_BEZIER");
    path = good;
    path.weights = weights;
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].weights and weight_count");
    path.weight_count = 3;
    check_path_refused(path, EW_ERROR_INVALID_ARGUMENT, "paths[2].weights[1]");
    for (int i = 0; i < 3; ++i) {
        points[3][i] = i == 1 ? NAN : INFINITY;
        check_path_refused(good, EW_ERROR_INVALID_ARGUMENT, "paths[2].points[3] must be finite");
        points[3][i] = 0;
    }
}

/* No point is read if there are too many: the array here is shorter than the counts say. */
static void too_many_pieces_are_refused(void **state)
{
    (void)state;
    double points[4][3] = {{0, 0, 0}, {5, 0, 0}, {-5, 3, 0}, {0, 5, 6}};
    ew_path path = {.kind = EW_PATH_BEZIER, .points = (const double(*)[3])points, .point_count = 4};
    ew_error error = {EW_OK, ""};
    size_t count = 7;
    check_refused(ew_count_path_pieces(&path, 1e-9, &name, &count, &error), &error, EW_ERROR_TOO_MANY_SOURCES,
                  "paths[2].points");
    points[3][0] = -1e308;
    points[0][0] = 1e308;
    check_refused(ew_count_path_pieces(&path, core, &name, &count, &error), &error, EW_ERROR_TOO_MANY_SOURCES,
                  "paths[2].points");
    assert_int_equal(count, 7);
    path.point_count = 3 * (EW_MAX_PATH_PIECES + 1) + 1;
    check_path_refused(path, EW_ERROR_TOO_MANY_SOURCES, "paths[2].points are too many");
    path.kind = EW_PATH_POLYLINE;
    path.point_count = SIZE_MAX;
    check_path_refused(path, EW_ERROR_TOO_MANY_SOURCES, "paths[2].points are too many");
}

static void as_many_pieces_as_promised_are_taken(void **state)
{
    (void)state;
    static double points[EW_MAX_PATH_PIECES + 1][3];
    static ew_path_piece pieces[EW_MAX_PATH_PIECES];
    for (size_t k = 0; k <= EW_MAX_PATH_PIECES; ++k)
        points[k][k % 3] = (double)k;
    ew_path path = {.points = (const double(*)[3])points, .point_count = EW_MAX_PATH_PIECES + 1};
    size_t count = 0;
    assert_int_equal(ew_check_path(&path, &name, NULL), EW_OK);
    assert_int_equal(ew_count_path_pieces(&path, core, &name, &count, NULL), EW_OK);
    assert_int_equal(count, EW_MAX_PATH_PIECES);
    ew_make_path_pieces(&path, core, pieces);
    check_close(pieces[count - 1].domain[1], 1, 0);
}

/* All of an arc is in its ball and its cylinder. Of a straight one, neither is larger than it must be. */
static void check_bounds(const ew_arc *arc, bool is_straight)
{
    const double rounding = 1e-12;
    double axis[3], radius = ew_cylinder_of_arc(arc, axis), farthest = 0;
    const ew_ball ball = ew_ball_of_arc(arc);
    check_close(ew_dot(axis, axis), 1, rounding);
    for (int k = 0; k <= SAMPLES; ++k) {
        double u = (double)k / SAMPLES, away[3], across[3];
        for (int i = 0; i < 3; ++i)
            away[i] = arc->start[i] + u * (arc->tangent[i] + u * arc->bend[i]) - ball.center[i];
        ew_cross(away, axis, across);
        farthest = fmax(farthest, sqrt(ew_dot(away, away)));
        assert_true(sqrt(ew_dot(across, across)) <= radius + rounding);
    }
    assert_true(farthest <= ball.radius + rounding);
    if (!is_straight) return;
    check_close(farthest, ball.radius, rounding);
    assert_true(radius <= 1e-6 * ball.radius);
}

static void pieces_are_in_their_balls_and_cylinders(void **state)
{
    (void)state;
    static made_path made;
    srand(7);
    for (int round = 0; round < 20; ++round) {
        make_random(&made, round % 2 ? EW_PATH_BSPLINE : EW_PATH_CATMULL_ROM, 9, round % 4 > 1);
        for (size_t k = 0; k < made.count; ++k) {
            const ew_quadratic *curve = &made.pieces[k].curve;
            ew_arc arc;
            memcpy(arc.start, curve->polynomial[0], sizeof arc.start);
            memcpy(arc.tangent, curve->polynomial[1], sizeof arc.tangent);
            memcpy(arc.bend, curve->polynomial[2], sizeof arc.bend);
            check_bounds(&arc, false);
        }
    }
    check_bounds(&(ew_arc){.tangent = {1, 2, 3}}, true);
    check_bounds(&(ew_arc){.tangent = {2, 0, 0}, .bend = {-2, 0, 0}}, false); /* folded back on itself */
    check_bounds(&(ew_arc){.start = {1, 2, 3}}, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_follows_its_definition),
        cmocka_unit_test(cubics_have_no_more_pieces_than_they_need),
        cmocka_unit_test(bspline_joins_half_way),
        cmocka_unit_test(two_points_are_one_straight_piece),
        cmocka_unit_test(pieces_are_straight_if_collinear_and_in_order),
        cmocka_unit_test(coincident_points_keep_the_shares),
        cmocka_unit_test(a_path_may_be_a_point),
        cmocka_unit_test(pieces_are_in_their_balls_and_cylinders),
        cmocka_unit_test(wrong_counts_are_refused),
        cmocka_unit_test(wrong_members_are_refused),
        cmocka_unit_test(too_many_pieces_are_refused),
        cmocka_unit_test(as_many_pieces_as_promised_are_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
