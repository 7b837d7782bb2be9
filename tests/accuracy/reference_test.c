/*
 * The reference against closed forms, hand-computed values and brute force in extended precision.
 */
#include "reference.h"
#include "reference_arc.h"
#include "reference_weight.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* ---- Random numbers: the same in every run --------------------------------------------------------------------------------
 */

static uint64_t random_state;

static double uniform(double low, double high)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(random_state >> 11) / 9007199254740992.0;
}

static double log_uniform(double low, double high)
{
    return exp(uniform(log(low), log(high)));
}

static void random_vector(double scale, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = uniform(-scale, scale);
}

/* ---- Brute force ----------------------------------------------------------------------------------------------------------
 */

static long double square_distance_to_curve_at(const ew_curve *curve, const long double p[3], long double t)
{
    long double square = 0;
    for (int i = 0; i < 3; i++) {
        long double c =
            curve->polynomial[0][i] + t * (curve->polynomial[1][i] + t * (long double)curve->polynomial[2][i]) - p[i];
        square += c * c;
    }
    return square;
}

static void try_parameter(const ew_curve *curve, const long double p[3], long double t, long double *best, long double *best_t)
{
    t = fminl(fmaxl(t, curve->domain[0]), curve->domain[1]);
    long double square = square_distance_to_curve_at(curve, p, t);
    if (!(square < *best)) return;
    *best = square;
    *best_t = t;
}

/* The nearest of 33 points of the arc, of that one polished by Newton's method, and of the roots of the cubic (12) by Cardano's
 * formula, polished too. */
static long double brute_force_curve_distance(const ew_curve *curve, const long double p[3], long double *nearest_t)
{
    enum { STEPS = 32 };
    const long double third_of_turn = 2.0943951023931954923L;
    long double cubic[4] = {0}, best = HUGE_VALL, starts[4];
    for (int i = 0; i < 3; i++) {
        long double c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i], c0 = curve->polynomial[0][i] - p[i];
        cubic[0] += c0 * c1;
        cubic[1] += c1 * c1 + 2 * c0 * c2;
        cubic[2] += 3 * c1 * c2;
        cubic[3] += 2 * c2 * c2;
    }
    for (int i = 0; i <= STEPS; i++) {
        long double t = curve->domain[0] + ((long double)curve->domain[1] - curve->domain[0]) * i / STEPS;
        try_parameter(curve, p, t, &best, nearest_t);
    }
    int count = 1;
    starts[0] = *nearest_t;
    if (cubic[3] > 0) {
        long double shift = -cubic[2] / (3 * cubic[3]);
        long double slope = cubic[1] / cubic[3] - 3 * shift * shift;
        long double constant = cubic[0] / cubic[3] + shift * (cubic[1] / cubic[3] + shift * (cubic[2] / cubic[3] + shift));
        long double r = constant * constant / 4 + slope * slope * slope / 27;
        if (r >= 0) {
            starts[count++] = cbrtl(-constant / 2 + sqrtl(r)) + cbrtl(-constant / 2 - sqrtl(r)) + shift;
        } else {
            long double angle = atan2l(sqrtl(-r), -constant / 2) / 3;
            for (int k = 0; k < 3; k++)
                starts[count++] = 2 * sqrtl(-slope / 3) * cosl(angle + k * third_of_turn) + shift;
        }
    }
    for (int i = 0; i < count; i++) {
        long double t = starts[i];
        for (int step = 0; step < 8; step++) {
            long double value = cubic[0] + t * (cubic[1] + t * (cubic[2] + t * cubic[3]));
            long double derivative = cubic[1] + t * (2 * cubic[2] + t * 3 * cubic[3]);
            if (derivative > 0) t -= value / derivative;
        }
        try_parameter(curve, p, t, &best, nearest_t);
    }
    return sqrtl(best);
}

/* The weight by de Boor's algorithm (not by the basis functions). */
static long double brute_force_weight(const ew_curve *curve, long double t)
{
    size_t n = curve->weight_count;
    const double *w = curve->weights;
    long double u = (t - curve->domain[0]) / ((long double)curve->domain[1] - curve->domain[0]);
    if (n == 0) return 1;
    if (n == 1) return w[0];
    if (n == 2) return (1 - u) * w[0] + u * w[1];
    long double scaled = u * (long double)(n - 2);
    size_t span = (size_t)floorl(scaled);
    if (span > n - 3) span = n - 3;
    /* In units of the inner knots' distance, the knots about the span, clamped to the ends. */
    long double k1 = span >= 1 ? (long double)span - 1 : 0, k2 = (long double)span, k3 = k2 + 1;
    long double k4 = fminl(k3 + 1, (long double)(n - 2));
    long double a = w[span] + (scaled - k1) / (k3 - k1) * ((long double)w[span + 1] - w[span]);
    long double b = w[span + 1] + (scaled - k2) / (k4 - k2) * ((long double)w[span + 2] - w[span + 1]);
    return a + (scaled - k2) / (k3 - k2) * (b - a);
}

typedef struct brute_force {
    const ew_sources_desc *sources; /* a single one */
    const reference_ray *ray;
} brute_force;

static long double brute_force_integrand(const brute_force *f, long double s)
{
    const ew_sources_desc *sources = f->sources;
    const reference_ray *ray = f->ray;
    long double p[3], distance, coefficient, weight = 1;
    for (int i = 0; i < 3; i++)
        p[i] = ray->start[i] + s * ((long double)ray->end[i] - ray->start[i]);
    if (sources->curve_count) {
        long double t = 0;
        distance = brute_force_curve_distance(sources->curves, p, &t);
        coefficient = sources->curves->coefficient;
        weight = brute_force_weight(sources->curves, t);
    } else {
        const double *from = sources->point_count  ? sources->points->position
                             : sources->line_count ? sources->lines->position
                                                   : sources->tori->center;
        for (int i = 0; i < 3; i++)
            p[i] -= from[i];
        const double no_axis[3] = {0, 0, 1};
        const double *axis = sources->line_count    ? sources->lines->direction
                             : sources->torus_count ? sources->tori->axis
                                                    : no_axis;
        long double norm = hypotl(hypotl(axis[0], axis[1]), axis[2]);
        long double height = (p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2]) / norm, across[3];
        for (int i = 0; i < 3; i++)
            across[i] = p[i] - height * axis[i] / norm;
        long double from_axis = hypotl(hypotl(across[0], across[1]), across[2]);
        distance = sources->point_count  ? hypotl(from_axis, height)
                   : sources->line_count ? from_axis
                                         : hypotl(from_axis - sources->tori->radius, height);
        coefficient = sources->point_count  ? sources->points->coefficient
                      : sources->line_count ? sources->lines->coefficient
                                            : sources->tori->coefficient;
    }
    long double s_plus_beta = s + ray->decay_beta;
    return coefficient * weight / fmaxl(sources->epsilon, distance) * ray->decay_alpha / (s_plus_beta * s_plus_beta);
}

/* Lobatto's rule with seven points. It samples the ends, and so sees kinks near them that Gauss's rules would miss. */
static long double lobatto(const brute_force *f, long double a, long double b)
{
    const long double root = 2 / 11.0L * sqrtl(5 / 3.0L), root15 = sqrtl(15);
    const long double nodes[] = {sqrtl(5 / 11.0L - root), sqrtl(5 / 11.0L + root), 1};
    const long double weights[] = {(124 + 7 * root15) / 350, (124 - 7 * root15) / 350, 1 / 21.0L};
    long double middle = 0.5L * (a + b), half = 0.5L * (b - a), sum = 256 / 525.0L * brute_force_integrand(f, middle);
    for (int i = 0; i < 3; i++)
        sum += weights[i] *
               (brute_force_integrand(f, middle - half * nodes[i]) + brute_force_integrand(f, middle + half * nodes[i]));
    return half * sum;
}

static const double BRUTE_FORCE_ERROR = 1e-8;

/* Bisects until the halves agree with the whole twice in a row, knowing nothing of the integrand. */
static long double bisect(const brute_force *f, long double a, long double b, long double whole, long double negligible,
                          bool agreed)
{
    long double middle = 0.5L * (a + b), left = lobatto(f, a, middle), right = lobatto(f, middle, b), halves = left + right;
    bool agrees = fabsl(halves - whole) <= 0.1L * BRUTE_FORCE_ERROR * halves + negligible;
    if (agrees && agreed) return halves;
    return bisect(f, a, middle, left, negligible, agrees) + bisect(f, middle, b, right, negligible, agrees);
}

static double brute_force_luminance(const ew_sources_desc *sources, const reference_ray *ray)
{
    enum { PANELS = 64 };
    brute_force f = {sources, ray};
    long double ends[PANELS + 1], parts[PANELS], rough = 0, sum = 0;
    for (int i = 0; i <= PANELS; i++)
        ends[i] = (long double)ray->s_max * i / PANELS;
    for (int i = 0; i < PANELS; i++)
        rough += parts[i] = lobatto(&f, ends[i], ends[i + 1]);
    for (int i = 0; i < PANELS; i++)
        sum += bisect(&f, ends[i], ends[i + 1], parts[i], 1e-13L * rough, false);
    return (double)sum;
}

static reference_workspace *workspace;

static int create_workspace(void **state)
{
    (void)state;
    return (workspace = reference_create_workspace()) ? 0 : -1;
}

static int destroy_workspace(void **state)
{
    (void)state;
    reference_destroy_workspace(workspace);
    return 0;
}

static void assert_matches_brute_force(const ew_sources_desc *sources, const reference_ray *ray, const char *what, int number)
{
    reference_value value;
    bool reliable = reference_luminance(workspace, sources, ray, &value, NULL);
    double truth = brute_force_luminance(sources, ray);
    double error = fabs(value.luminance - truth);
    if (!reliable || error > value.error + BRUTE_FORCE_ERROR * truth)
        fail_msg("%s %d: %.12g +- %.1e, by brute force %.12g", what, number, value.luminance, value.error, truth);
}

/* ---- Weights --------------------------------------------------------------------------------------------------------------
 */

static void equal_weights_are_constant(void **state)
{
    (void)state;
    double weights[64];
    for (int i = 0; i < 64; i++)
        weights[i] = 0.7;
    for (size_t n = 1; n <= 64; n++)
        for (int i = 0; i <= 1000; i++)
            assert_true(fabs(reference_weight(weights, n, i / 1000.0) - 0.7) < 1e-15);
    assert_true(reference_weight(NULL, 0, 0.3) == 1);
}

/* A B-spline whose control values are its Greville abscissae (the means of the inner knots) is the identity. */
static void greville_abscissae_as_weights_give_the_identity(void **state)
{
    (void)state;
    for (int n = 3; n <= 64; n++) {
        double weights[64];
        for (int i = 0; i < n; i++) {
            double low = i >= 1 ? i - 1 : 0, high = i <= n - 2 ? i : n - 2;
            weights[i] = 0.5 * (low + high) / (n - 2);
        }
        for (int i = 0; i <= 1000; i++)
            assert_true(fabs(reference_weight(weights, (size_t)n, i / 1000.0) - i / 1000.0) < 1e-14);
    }
}

static void weights_match_values_computed_by_hand(void **state)
{
    (void)state;
    assert_true(reference_weight((double[]){0.25}, 1, 0.9) == 0.25);
    assert_true(fabs(reference_weight((double[]){1, 3}, 2, 0.25) - 1.5) < 1e-15);
    /* n = 3 is a Bezier: (w0 + 2 w1 + w2) / 4 in the middle. */
    assert_true(fabs(reference_weight((double[]){1, 2, 7}, 3, 0.5) - 3) < 1e-15);
    /* n = 4 has one inner knot, at 1/2: N0 = (1 - 2u)^2 = 1/4 and N2 = 2u^2 = 1/8 at u = 1/4; N1 is the rest. At the knot, N1
     * and N2 share evenly. */
    assert_true(fabs(reference_weight((double[]){8, 0, 0, 0}, 4, 0.25) - 2) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 8, 0, 0}, 4, 0.25) - 5) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 0, 8, 0}, 4, 0.25) - 1) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 0, 0, 8}, 4, 0.25) - 0) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 8, 0, 0}, 4, 0.5) - 4) < 1e-15);
    assert_true(fabs(reference_weight((double[]){0, 0, 8, 0}, 4, 0.5) - 4) < 1e-15);
}

static void weights_start_and_end_at_the_first_and_last(void **state)
{
    (void)state;
    const double weights[] = {0.3, 0.9, 0.1, 0.5, 0.7};
    for (size_t n = 2; n <= 5; n++) {
        assert_true(reference_weight(weights, n, 0) == weights[0]);
        assert_true(reference_weight(weights, n, 1) == weights[n - 1]);
    }
}

/* ---- Distances ------------------------------------------------------------------------------------------------------------
 */

static ew_curve random_curve(int shape)
{
    ew_curve curve = {.domain = {0, 1}, .coefficient = 1};
    double points[3][3];
    for (int i = 0; i < 3; i++)
        random_vector(2, points[i]);
    double bend = (const double[]){1, 1e-2, 1e-4, 1e-7, 0}[shape % 5];
    if (shape >= 5 && shape < 10) /* nearly or exactly straight */
        for (int i = 0; i < 3; i++)
            points[1][i] = 0.5 * (points[0][i] + points[2][i]) + bend * (points[1][i] - points[0][i]);
    if (shape >= 10 && shape < 15) /* collinear, folded back, or a narrow hairpin */
        for (int i = 0; i < 3; i++)
            points[1][i] = points[0][i] + 1.5 * (points[2][i] - points[0][i]) + 1e-2 * bend * points[1][i];
    if (shape == 15) memcpy(points[1], points[0], sizeof points[1]);
    if (shape == 16) memcpy(points[1], points[2], sizeof points[1]);
    if (shape == 17) memcpy(points[2], points[0], sizeof points[2]);
    if (shape == 18) memcpy(points[1], points[0], sizeof points[1]), memcpy(points[2], points[0], sizeof points[2]);
    for (int i = 0; i < 3; i++) {
        curve.polynomial[0][i] = points[0][i];
        curve.polynomial[1][i] = 2 * (points[1][i] - points[0][i]);
        curve.polynomial[2][i] = points[0][i] - 2 * points[1][i] + points[2][i];
    }
    if (shape == 19) curve.domain[0] = -2, curve.domain[1] = 1.5;
    return curve;
}
enum { CURVE_SHAPES = 20 };

static void distances_to_curves_match_brute_force(void **state)
{
    (void)state;
    random_state = 1;
    for (int i = 0; i < 4000; i++) {
        ew_curve curve = random_curve(i % CURVE_SHAPES);
        double point[3], t;
        random_vector(3, point);
        const long double p[3] = {point[0], point[1], point[2]};
        long double brute_force_t = 0;
        double truth = (double)brute_force_curve_distance(&curve, p, &brute_force_t);
        double distance = reference_curve_distance(&curve, point, &t);
        if (fabs(distance - truth) > 1e-14 * (10 + truth)) fail_msg("case %d: %.17g, by brute force %.17g", i, distance, truth);
        assert_true(fabs((double)sqrtl(square_distance_to_curve_at(&curve, p, t)) - distance) < 1e-14 * (10 + truth));
        assert_true(t >= curve.domain[0] && t <= curve.domain[1]);
    }
}

/* ---- Luminance against closed forms ---------------------------------------------------------------------------------------
 */

/* The integral from s0 to s1 of 1/sqrt(b^2 + k (s - sc)^2) / (s + beta)^2: with y = 1/(s + beta) it becomes that of
 * y / sqrt(k + 2 B y + C y^2), B = -k (sc + beta), C = b^2 + k (sc + beta)^2, whose antiderivative is in every table. */
static long double table_integral(long double b, long double k, long double sc, long double beta, long double s0,
                                  long double s1)
{
    long double sigma = sc + beta, B = -k * sigma, C = b * b + k * sigma * sigma;
    long double result = 0;
    for (int end = 0; end < 2; end++) {
        long double y = 1 / ((end ? s1 : s0) + beta);
        /* asinh of (C y + B) / sqrt(C k - B^2), where C k - B^2 = k b^2 */
        long double antiderivative =
            sqrtl(k + 2 * B * y + C * y * y) / C - B / (C * sqrtl(C)) * asinhl((C * y + B) / (sqrtl(k) * b));
        result += end ? -antiderivative : antiderivative;
    }
    return result;
}

/* The same with the distance's floor at epsilon. */
static double closed_form(long double b, long double k, long double sc, long double beta, long double s_max,
                          long double epsilon)
{
    if (b >= epsilon) return (double)table_integral(b, k, sc, beta, 0, s_max);
    long double half = sqrtl((epsilon - b) * (epsilon + b) / k);
    long double enter = fminl(fmaxl(sc - half, 0), s_max), leave = fminl(fmaxl(sc + half, 0), s_max);
    return (double)(table_integral(b, k, sc, beta, 0, enter) + (leave - enter) / ((enter + beta) * (leave + beta)) / epsilon +
                    table_integral(b, k, sc, beta, leave, s_max));
}

static reference_ray random_ray(double longest)
{
    reference_ray ray = {.s_max = uniform(0, 2) > 1 ? 1 : uniform(0.1, 1), .decay_alpha = uniform(0.5, 2)};
    ray.decay_beta = log_uniform(0.05, 4);
    double direction[3];
    random_vector(3, ray.start);
    random_vector(1, direction);
    double ray_length = log_uniform(3, longest);
    for (int i = 0; i < 3; i++)
        ray.end[i] = ray.start[i] + ray_length * direction[i];
    return ray;
}

/* A point that the ray passes at a distance of about `miss`. */
static void point_near_ray(const reference_ray *ray, double miss, double point[3])
{
    double away[3], ray_length = 0;
    random_vector(1, away);
    for (int i = 0; i < 3; i++)
        ray_length += fabs(ray->end[i] - ray->start[i]);
    double s = fmin(1, 3 / ray_length) * uniform(0, 1);
    for (int i = 0; i < 3; i++)
        point[i] = ray->start[i] + s * (ray->end[i] - ray->start[i]) + miss * away[i];
}

static void points_and_lines_match_their_closed_forms(void **state)
{
    (void)state;
    random_state = 2;
    double worst = 0;
    for (int i = 0; i < 4000; i++) {
        reference_ray ray = random_ray(i % 2 ? 20 : 1e4);
        double epsilon = log_uniform(1e-6, 1e-1), position[3], direction[3];
        point_near_ray(&ray, i % 3 ? log_uniform(1e-8, 3) : 0.5 * epsilon, position);
        random_vector(1, direction);
        ew_point point = {.coefficient = 2};
        ew_line line = {.coefficient = 2};
        memcpy(point.position, position, sizeof position);
        memcpy(line.position, position, sizeof position);
        memcpy(line.direction, direction, sizeof direction);
        bool is_line = i % 4 >= 2;
        ew_sources_desc sources = {.epsilon = epsilon};
        if (is_line)
            sources.lines = &line, sources.line_count = 1;
        else
            sources.points = &point, sources.point_count = 1;

        /* The squared distance along the ray is k (s - sc)^2 + b^2; for a line, all components along it drop out. */
        long double d[3], m[3], k = 0, dm = 0, b2 = 0, norm2 = 0, d_along = 0, m_along = 0;
        for (int j = 0; j < 3; j++) {
            d[j] = (long double)ray.end[j] - ray.start[j];
            m[j] = (long double)position[j] - ray.start[j];
            norm2 += (long double)direction[j] * direction[j];
            d_along += d[j] * direction[j];
            m_along += m[j] * direction[j];
        }
        for (int j = 0; j < 3; j++) {
            if (is_line) {
                d[j] -= d_along / norm2 * direction[j];
                m[j] -= m_along / norm2 * direction[j];
            }
            k += d[j] * d[j];
            dm += d[j] * m[j];
        }
        long double sc = dm / k;
        for (int j = 0; j < 3; j++)
            b2 += (m[j] - sc * d[j]) * (m[j] - sc * d[j]);
        double truth = 2 * ray.decay_alpha * closed_form(sqrtl(b2), k, sc, ray.decay_beta, ray.s_max, epsilon);

        reference_value value;
        bool reliable = reference_luminance(workspace, &sources, &ray, &value, NULL);
        double error = fabs(value.luminance - truth);
        if (error / truth > worst) worst = error / truth;
        if (!reliable || error > 1e-9 * truth)
            fail_msg("case %d: %.12g +- %.1e, in closed form %.12g", i, value.luminance, value.error, truth);
    }
    print_message("largest relative error against closed forms: %.1e\n", worst);
}

/* ---- Luminance against brute force ----------------------------------------------------------------------------------------
 */

static void random_curves_match_brute_force(void **state)
{
    (void)state;
    random_state = 3;
    double weights[64];
    for (int i = 0; i < 64; i++)
        weights[i] = i % 5 == 4 ? 0 : uniform(0, 1);
    for (int i = 0; i < 120; i++) {
        int shape = i % CURVE_SHAPES;
        ew_curve curve = random_curve(shape);
        reference_ray ray = random_ray(i % 2 ? 20 : 1e3);
        double shift[3];
        point_near_ray(&ray, log_uniform(1e-4, 1), shift);
        for (int k = 0; k < 3; k++) {
            double t = 0.4;
            curve.polynomial[0][k] = shift[k] - t * curve.polynomial[1][k] - t * t * curve.polynomial[2][k];
        }
        /* Where an arc runs back over itself, or so nearly that rounding decides, or is a point, its weight is nobody's to say.
         */
        bool ambiguous = shape == 13 || shape == 14 || shape == 17 || shape == 18;
        const size_t counts[] = {0, 1, 2, 3, 7, 64};
        curve.weight_count = ambiguous ? 0 : counts[(i / CURVE_SHAPES) % 6];
        if (curve.weight_count) curve.weights = weights;
        ew_sources_desc sources = {.curves = &curve, .curve_count = 1, .epsilon = log_uniform(1e-4, 1e-1)};
        assert_matches_brute_force(&sources, &ray, "curve", i);
    }
}

/* Once overlooked: the one short stretch of a ray that sees the inside of an arc whose weights are 0 at both ends. The light is
 * linear in the weights. */
static void arcs_dark_at_both_ends_shine_in_between(void **state)
{
    (void)state;
    static const double weights[3][3] = {{0, 1, 0}, {1, 1, 1}, {1, 0, 1}};
    double luminance[3];
    for (int i = 0; i < 3; i++) {
        ew_curve curve = {.polynomial = {{0, 0, 0}, {0.01, -0.0995, 0}, {0, 0, 0.001}},
                          .domain = {0, 1},
                          .weights = weights[i],
                          .weight_count = 3,
                          .coefficient = 1};
        ew_sources_desc sources = {.curves = &curve, .curve_count = 1, .epsilon = 1e-4};
        reference_ray ray = {.start = {-300, 10, 0}, .end = {300, 10, 0}, .s_max = 1, .decay_alpha = 1, .decay_beta = 1};
        reference_value value;
        assert_true(reference_luminance(workspace, &sources, &ray, &value, NULL));
        luminance[i] = value.luminance;
    }
    assert_true(luminance[0] > 0);
    assert_true(fabs(luminance[0] - (luminance[1] - luminance[2])) < 1e-6 * luminance[0]);
}

static void random_tori_match_brute_force(void **state)
{
    (void)state;
    random_state = 4;
    for (int i = 0; i < 120; i++) {
        reference_ray ray = random_ray(i % 2 ? 20 : 1e3);
        ew_torus torus = {.coefficient = 3, .radius = i % 10 == 0 ? 0 : log_uniform(1e-2, 3)};
        random_vector(1, torus.axis);
        point_near_ray(&ray, log_uniform(1e-4, 3), torus.center);
        ew_sources_desc sources = {.tori = &torus, .torus_count = 1, .epsilon = log_uniform(1e-4, 1e-1)};
        assert_matches_brute_force(&sources, &ray, "torus", i);
    }
}

static void hard_rays_match_brute_force(void **state)
{
    (void)state;
    static const double from[][3] = {{-4, 0, 0},    {0, 0, 0},    {0, 0, -4},    {-4, 1, 0},
                                     {-4, 0, 1e-5}, {0, 0, 1e-3}, {1e-7, 0, -4}, {-4, 1 - 1e-4, 0}};
    static const double to[][3] = {{4, 0, 0},    {4, 0, 0},    {0, 0, 4},    {4, 1, 0},
                                   {4, 0, 1e-5}, {8, 0, 1e-3}, {1e-7, 0, 4}, {4, 1 - 1e-4, 0}};
    ew_point point = {.position = {0, 0, 0}, .coefficient = 1};
    ew_line line = {.position = {7, 0, 0}, .direction = {2, 0, 0}, .coefficient = 1};
    ew_torus torus = {.axis = {0, 0, 1}, .radius = 1, .coefficient = 1};
    ew_torus dot = {.axis = {0, 0, 1}, .radius = 0, .coefficient = 1};
    ew_curve straight = {.polynomial = {{-1, 0, 0}, {2, 0, 0}, {0, 0, 0}}, .domain = {0, 1}, .coefficient = 1};
    ew_curve parabola = {.polynomial = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, .domain = {-1, 1}, .coefficient = 1};
    ew_curve folded = {.polynomial = {{-1, 0, 0}, {4, 0, 0}, {-4, 0, 0}}, .domain = {0, 1}, .coefficient = 1};
    ew_curve hairpin = {.polynomial = {{0, 0, 0}, {0, 0.01, 0}, {2, 0, 0}}, .domain = {-1, 1}, .coefficient = 1};
    const ew_sources_desc fields[] = {
        {.points = &point, .point_count = 1},  {.lines = &line, .line_count = 1},       {.tori = &torus, .torus_count = 1},
        {.tori = &dot, .torus_count = 1},      {.curves = &straight, .curve_count = 1}, {.curves = &parabola, .curve_count = 1},
        {.curves = &folded, .curve_count = 1}, {.curves = &hairpin, .curve_count = 1},
    };
    for (size_t ray_number = 0; ray_number < sizeof from / sizeof from[0]; ray_number++)
        for (size_t field = 0; field < sizeof fields / sizeof fields[0]; field++) {
            reference_ray ray = {.s_max = 1, .decay_alpha = 1, .decay_beta = 0.5};
            memcpy(ray.start, from[ray_number], sizeof ray.start);
            memcpy(ray.end, to[ray_number], sizeof ray.end);
            ew_sources_desc sources = fields[field];
            sources.epsilon = 1e-4;
            assert_matches_brute_force(&sources, &ray, "ray, field", (int)(10 * ray_number + field));
        }
}

static void shares_add_up_in_the_order_of_the_kinds(void **state)
{
    (void)state;
    random_state = 5;
    ew_point points[2] = {{.position = {1, 0, 0}, .coefficient = 1}, {.position = {0, 2, 0}, .coefficient = 0}};
    ew_line line = {.position = {0, 1, 0}, .direction = {0, 0, 3}, .coefficient = 2};
    ew_torus torus = {.axis = {0, 0, 1}, .radius = 1, .coefficient = 3};
    ew_curve curve = random_curve(0);
    const ew_sources_desc all = {points, 2, &line, 1, &torus, 1, &curve, 1, 1e-3};
    const ew_sources_desc alone[] = {
        {.points = points, .point_count = 1, .epsilon = 1e-3}, {.points = points + 1, .point_count = 1, .epsilon = 1e-3},
        {.lines = &line, .line_count = 1, .epsilon = 1e-3},    {.tori = &torus, .torus_count = 1, .epsilon = 1e-3},
        {.curves = &curve, .curve_count = 1, .epsilon = 1e-3},
    };
    for (int i = 0; i < 20; i++) {
        reference_ray ray = random_ray(20);
        reference_value sum, shares[5], value;
        double total = 0;
        assert_true(reference_luminance(workspace, &all, &ray, &sum, shares));
        for (int k = 0; k < 5; k++) {
            assert_true(reference_luminance(workspace, &alone[k], &ray, &value, NULL));
            assert_true(value.luminance == shares[k].luminance);
            total += value.luminance;
        }
        assert_true(shares[1].luminance == 0);
        assert_true(fabs(total - sum.luminance) <= 1e-14 * total);
    }
}

static void nothing_shines_before_the_ray_starts(void **state)
{
    (void)state;
    ew_point point = {.coefficient = 1};
    ew_sources_desc sources = {.points = &point, .point_count = 1, .epsilon = 1e-3};
    reference_ray ray = {.start = {-1, 0, 0}, .end = {1, 0, 0}, .s_max = 0, .decay_alpha = 1, .decay_beta = 1};
    reference_value value;
    assert_true(reference_luminance(workspace, &sources, &ray, &value, NULL));
    assert_true(value.luminance == 0);
    ray.s_max = 1;
    sources.point_count = 0;
    assert_true(reference_luminance(workspace, &sources, &ray, &value, NULL));
    assert_true(value.luminance == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_weights_are_constant),
        cmocka_unit_test(greville_abscissae_as_weights_give_the_identity),
        cmocka_unit_test(weights_match_values_computed_by_hand),
        cmocka_unit_test(weights_start_and_end_at_the_first_and_last),
        cmocka_unit_test(distances_to_curves_match_brute_force),
        cmocka_unit_test(points_and_lines_match_their_closed_forms),
        cmocka_unit_test(random_curves_match_brute_force),
        cmocka_unit_test(arcs_dark_at_both_ends_shine_in_between),
        cmocka_unit_test(random_tori_match_brute_force),
        cmocka_unit_test(hard_rays_match_brute_force),
        cmocka_unit_test(shares_add_up_in_the_order_of_the_kinds),
        cmocka_unit_test(nothing_shines_before_the_ray_starts),
    };
    return cmocka_run_group_tests_name("reference", tests, create_workspace, destroy_workspace);
}
