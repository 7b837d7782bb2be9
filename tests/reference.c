/*
 * The reference: see reference.h.
 *
 * The integrand of a source has peaks as narrow as the core (closest approaches), kinks (the nearest point enters or leaves
 * an end of the arc, or a knot; the ray enters or leaves the core) and jumps (the nearest point leaps between the branches of
 * a weighted curve). All are looked for by sampling along the ray and narrowed down by bisection, and become break points,
 * with further ones in geometric progression around every peak. What the search misses, the error estimates of Gauss-Kronrod
 * quadrature see.
 */
#include "reference.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define UNIFORM_SAMPLES 17
#define SEEDS 9
#define MAX_SAMPLES 4096
#define MAX_PEAKS 16
#define MAX_BREAK_POINTS 2048
#define MAX_PANELS 8192

/* ---- Vectors --------------------------------------------------------------------------------------------------------------
 */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double length(const double a[3])
{
    return sqrt(dot(a, a));
}

/* result = a + scale b */
static void add_scaled(const double a[3], double scale, const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] + scale * b[i];
}

/* ---- Weights --------------------------------------------------------------------------------------------------------------
 */

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

/* The polynomial piece that u is on. Only the three basis functions from this one on differ from 0 there. */
static int weight_span(size_t count, double u)
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
    int span = weight_span(count, u);
    for (int i = span; i < span + 3; i++)
        sum += weights[i] * basis(i, 2, (int)count, u);
    return sum;
}

/* ---- Nearest points -------------------------------------------------------------------------------------------------------
 */

typedef enum source_kind { POINT, LINE, TORUS, CURVE } source_kind;

typedef struct field_source {
    source_kind kind;
    /* The point, a point of the line, the torus's centre or the curve's C0, from where the integrand's positions start. */
    double position[3];
    double axis[3]; /* unit direction of the line, unit axis of the torus */
    double radius;
    const ew_curve *curve;
    double coefficient;
} field_source;

/* Which piece of an arc the nearest point is on. The nearest point of a whole parabola leaps only across the plane of
 * symmetry, so that where it leaps, or becomes an end, the piece changes. */
typedef enum piece { WHOLE, FIRST_END, LAST_END, BEFORE_VERTEX, BEHIND_VERTEX } piece;

typedef struct nearest_point {
    double distance;
    double offset[3]; /* from the nearest point to the point asked about */
    double t;         /* of a curve */
    piece piece;
} nearest_point;

/* Half the derivative of the squared distance between C(t) and a point, by t; `from` is C0 minus the point. */
static double curve_slope(const ew_curve *curve, const double from[3], double t)
{
    double slope = 0;
    for (int i = 0; i < 3; i++) {
        double c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i];
        slope += (from[i] + t * (c1 + t * c2)) * (c1 + 2 * t * c2);
    }
    return slope;
}

/* The root of curve_slope between low, where it is negative, and high, where it is positive: Newton's method, kept within the
 * bracket by bisection. */
static double curve_stationary_point(const ew_curve *curve, const double from[3], double low, double high)
{
    const double *c1 = curve->polynomial[1], *c2 = curve->polynomial[2];
    double t = 0.5 * (low + high), smallest_step = 2.3e-16 * (fabs(curve->domain[0]) + fabs(curve->domain[1]));
    double step = high - low;
    for (int i = 0; i < 200; i++) {
        double slope = curve_slope(curve, from, t);
        if (slope == 0) return t;
        if (slope < 0)
            low = t;
        else
            high = t;
        double derivative = dot(c1, c1) + 2 * dot(c2, from) + 6 * t * (dot(c1, c2) + t * dot(c2, c2));
        double next = t - slope / derivative;
        if (!(next > low && next < high && 2 * fabs(next - t) < fabs(step))) next = 0.5 * (low + high);
        step = next - t;
        t = next;
        if (fabs(step) <= smallest_step) return t;
    }
    return t;
}

/* The nearest of all stationary points and the two ends. Stationary points are bracketed between the ends and the critical
 * points of the cubic that they are the roots of: in between it is monotone. */
static nearest_point nearest_of_curve(const ew_curve *curve, const double from[3])
{
    const double *c1 = curve->polynomial[1], *c2 = curve->polynomial[2];
    double first = curve->domain[0], last = curve->domain[1];
    double edges[4] = {first};
    int edge_count = 1;
    double a = 3 * dot(c2, c2), b = 3 * dot(c1, c2), c = 0.5 * dot(c1, c1) + dot(c2, from);
    double discriminant = b * b - 4 * a * c;
    if (discriminant > 0 && a > 0) {
        double q = -0.5 * (b + copysign(sqrt(discriminant), b));
        double low = fmin(q / a, c / q), high = fmax(q / a, c / q);
        if (low > first && low < last) edges[edge_count++] = low;
        if (high > first && high < last) edges[edge_count++] = high;
    }
    edges[edge_count] = last;

    double candidates[5] = {first};
    int candidate_count = 1;
    double slope = curve_slope(curve, from, first);
    for (int i = 0; i < edge_count; i++) {
        double next_slope = curve_slope(curve, from, edges[i + 1]);
        if (slope < 0 && next_slope > 0)
            candidates[candidate_count++] = curve_stationary_point(curve, from, edges[i], edges[i + 1]);
        slope = next_slope;
    }
    candidates[candidate_count++] = last;

    nearest_point best = {.distance = HUGE_VAL};
    double best_square = HUGE_VAL;
    for (int i = 0; i < candidate_count; i++) {
        double offset[3], t = candidates[i];
        for (int k = 0; k < 3; k++)
            offset[k] = -(from[k] + t * (c1[k] + t * c2[k]));
        double square = dot(offset, offset);
        /* Of points as good as equally near, the first, so that an arc that runs back on itself does not flicker. */
        if (square >= best_square * (1 - 1e-13)) continue;
        best_square = square;
        best.t = t;
        memcpy(best.offset, offset, sizeof offset);
    }
    best.distance = sqrt(best_square);
    best.piece = best.t <= first                              ? FIRST_END
                 : best.t >= last                             ? LAST_END
                 : 2 * dot(c2, c2) * best.t + dot(c1, c2) < 0 ? BEFORE_VERTEX
                                                              : BEHIND_VERTEX;
    return best;
}

static nearest_point nearest_of_source(const field_source *source, const double point[3])
{
    nearest_point result = {.piece = WHOLE};
    double from[3]; /* from the point to the source */
    add_scaled(source->position, -1, point, from);
    if (source->kind == CURVE) return nearest_of_curve(source->curve, from);

    for (int i = 0; i < 3; i++)
        result.offset[i] = -from[i];
    double height = dot(result.offset, source->axis);
    if (source->kind == LINE) add_scaled(result.offset, -height, source->axis, result.offset);
    if (source->kind == TORUS) {
        double radial[3];
        add_scaled(result.offset, -height, source->axis, radial);
        double distance_from_axis = length(radial);
        /* On the axis all of the circle is equally near; leaving the radial part at 0 then is right by symmetry. */
        double scale = distance_from_axis > 0 ? (distance_from_axis - source->radius) / distance_from_axis : 0;
        for (int i = 0; i < 3; i++)
            result.offset[i] = radial[i] * scale + source->axis[i] * height;
        result.distance = hypot(distance_from_axis - source->radius, height);
    } else {
        result.distance = length(result.offset);
    }
    return result;
}

double reference_curve_distance(const ew_curve *curve, const double point[3], double *t)
{
    double from[3];
    add_scaled(curve->polynomial[0], -1, point, from);
    nearest_point result = nearest_of_curve(curve, from);
    if (t) *t = result.t;
    return result.distance;
}

/* ---- The integrand --------------------------------------------------------------------------------------------------------
 */

/* Positions on the ray are measured by x = s - origin_s, places from L(origin_s): near the narrowest peak, they keep the digits
 * that s would lose. What they are differences of is kept in extended precision for the same reason. */
typedef struct integrand {
    field_source source;
    double direction[3]; /* E - S */
    long double position_from_start[3];
    long double exact_axis[3];
    long double exact_direction[3];
    double origin_s;
    double alpha, beta, epsilon;
} integrand;

typedef struct sample {
    double x;
    double slope;    /* sign of the derivative of the distance by x, with what may be noise as 0 */
    double distance; /* not below epsilon */
    double value;    /* the integrand's */
    double most;     /* what it would be with the source's largest weight */
    int label;       /* changes at every kink and jump */
} sample;

static sample sample_integrand(const integrand *f, double x)
{
    double point[3];
    for (int i = 0; i < 3; i++)
        point[i] = x * f->direction[i];
    nearest_point nearest = nearest_of_source(&f->source, point);
    bool inside_core = nearest.distance < f->epsilon;
    double weight = 1, largest_weight = 1;
    int span = 0;
    if (f->source.kind == CURVE) {
        const ew_curve *curve = f->source.curve;
        double u = (nearest.t - curve->domain[0]) / (curve->domain[1] - curve->domain[0]);
        weight = reference_weight(curve->weights, curve->weight_count, u);
        span = weight_span(curve->weight_count, u);
        for (size_t i = 0; i < curve->weight_count; i++)
            largest_weight = i == 0 ? curve->weights[i] : fmax(largest_weight, curve->weights[i]);
    }
    double s_plus_beta = f->origin_s + x + f->beta;
    double distance = fmax(f->epsilon, nearest.distance);
    double unweighted = f->source.coefficient / distance * f->alpha / (s_plus_beta * s_plus_beta);
    double slope = dot(f->direction, nearest.offset);
    double noise = 1e-9 * length(f->direction) * nearest.distance;
    return (sample){
        .x = x,
        .slope = slope > noise    ? 1
                 : slope < -noise ? -1
                                  : 0,
        .distance = distance,
        .value = weight * unweighted,
        .most = largest_weight * unweighted,
        .label = (span * 8 + (int)nearest.piece) * 2 + inside_core,
    };
}

static double integrand_value(double x, void *f)
{
    return sample_integrand(f, x).value;
}

static double distance_slope(double x, void *parameters)
{
    const integrand *f = parameters;
    double point[3];
    for (int i = 0; i < 3; i++)
        point[i] = x * f->direction[i];
    nearest_point nearest = nearest_of_source(&f->source, point);
    return dot(f->direction, nearest.offset);
}

static void set_origin(integrand *f, double origin_s)
{
    long double position[3], along = 0;
    for (int i = 0; i < 3; i++) {
        position[i] = f->position_from_start[i] - origin_s * f->exact_direction[i];
        along += position[i] * f->exact_axis[i];
    }
    /* Any point of a line serves: the nearest keeps the most digits. */
    for (int i = 0; i < 3; i++)
        f->source.position[i] = (double)(position[i] - (f->source.kind == LINE ? along * f->exact_axis[i] : 0));
    f->origin_s = origin_s;
}

typedef struct quadrature_panel {
    double low, high;
    double value, error;
} quadrature_panel;

/* ---- The search for break points ------------------------------------------------------------------------------------------
 */

struct reference_workspace {
    gsl_root_fsolver *solver;
    quadrature_panel panels[MAX_PANELS];
    sample samples[MAX_SAMPLES];
    size_t sample_count;
    double peaks[MAX_PEAKS];
    size_t peak_count;
    double break_points[MAX_BREAK_POINTS];
    size_t break_point_count;
};

reference_workspace *reference_create_workspace(void)
{
    gsl_set_error_handler_off();
    reference_workspace *workspace = calloc(1, sizeof *workspace);
    if (!workspace) return NULL;
    workspace->solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (workspace->solver) return workspace;
    free(workspace);
    return NULL;
}

void reference_destroy_workspace(reference_workspace *workspace)
{
    if (!workspace) return;
    gsl_root_fsolver_free(workspace->solver);
    free(workspace);
}

static int compare_samples(const void *a, const void *b)
{
    const sample *first = a, *second = b;
    return (first->x > second->x) - (first->x < second->x);
}

static int compare_numbers(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

/* Adds a sample where x is within the ray's range. Beyond the limits of the workspace, samples and break points are dropped:
 * that costs QAGP time and maybe its error bound, which is told. */
static void add_sample(reference_workspace *workspace, const integrand *f, double x, double end)
{
    if (x >= 0 && x <= end && workspace->sample_count < MAX_SAMPLES)
        workspace->samples[workspace->sample_count++] = sample_integrand(f, x);
}

static void add_break_point(reference_workspace *workspace, double x, double end)
{
    if (x > 0 && x < end && workspace->break_point_count < MAX_BREAK_POINTS - 2)
        workspace->break_points[workspace->break_point_count++] = x;
}

/* Samples where the ray comes nearest to some points of the source, so that a source that is short along the ray is seen. */
static void add_seeds(reference_workspace *workspace, const integrand *f, double end)
{
    const field_source *source = &f->source;
    double first_radial[3] = {0}, second_radial[3];
    if (source->kind == TORUS) {
        int smallest = fabs(source->axis[0]) < fabs(source->axis[1]) ? 0 : 1;
        if (fabs(source->axis[2]) < fabs(source->axis[smallest])) smallest = 2;
        first_radial[smallest] = 1;
        add_scaled(first_radial, -dot(first_radial, source->axis), source->axis, first_radial);
        double norm = length(first_radial);
        for (int i = 0; i < 3; i++)
            first_radial[i] /= norm;
        for (int i = 0; i < 3; i++)
            second_radial[i] =
                source->axis[(i + 1) % 3] * first_radial[(i + 2) % 3] - source->axis[(i + 2) % 3] * first_radial[(i + 1) % 3];
    }
    for (int k = 0; k < (source->kind == TORUS || source->kind == CURVE ? SEEDS : 1); k++) {
        double seed[3];
        memcpy(seed, source->position, sizeof seed);
        if (source->kind == TORUS) {
            add_scaled(seed, source->radius * cos(2 * M_PI * k / SEEDS), first_radial, seed);
            add_scaled(seed, source->radius * sin(2 * M_PI * k / SEEDS), second_radial, seed);
        } else if (source->kind == CURVE) {
            const ew_curve *curve = source->curve;
            double t = curve->domain[0] + k / (SEEDS - 1.0) * (curve->domain[1] - curve->domain[0]);
            add_scaled(seed, t, curve->polynomial[1], seed);
            add_scaled(seed, t * t, curve->polynomial[2], seed);
        }
        add_sample(workspace, f, dot(seed, f->direction) / dot(f->direction, f->direction), end);
    }
}

static bool has_peak_within(const reference_workspace *workspace, double low, double high)
{
    for (size_t i = 0; i < workspace->peak_count; i++)
        if (workspace->peaks[i] >= low && workspace->peaks[i] <= high) return true;
    return false;
}

static double solve_slope(gsl_root_fsolver *solver, integrand *f, double low, double high)
{
    gsl_function slope = {distance_slope, f};
    if (gsl_root_fsolver_set(solver, &slope, low, high) != GSL_SUCCESS) return 0.5 * (low + high);
    for (int i = 0; i < 100; i++) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS) break;
        double width = gsl_root_fsolver_x_upper(solver) - gsl_root_fsolver_x_lower(solver);
        double root = gsl_root_fsolver_root(solver);
        if (width <= 1e-15 * fabs(root)) break;
    }
    return gsl_root_fsolver_root(solver);
}

/* Finds the closest approaches: the ends of the ray where the distance grows inwards, and wherever the samples show that its
 * slope turns from negative to positive. Every new one brings new samples and break points, in geometric progression on
 * either side, from its own distance on: between two of them the singularities of 1/distance stay well off the panel. */
static void find_peaks(reference_workspace *workspace, integrand *f, double end)
{
    double ray_length = length(f->direction);
    for (size_t handled = 0;;) {
        qsort(workspace->samples, workspace->sample_count, sizeof(sample), compare_samples);
        const sample *samples = workspace->samples;
        size_t count = workspace->sample_count;
        if (handled == 0) {
            if (samples[0].slope >= 0) workspace->peaks[workspace->peak_count++] = 0;
            if (samples[count - 1].slope <= 0) workspace->peaks[workspace->peak_count++] = end;
        }
        for (size_t i = 0; i + 1 < count && workspace->peak_count < MAX_PEAKS; i++) {
            double low = samples[i].x, high = samples[i + 1].x;
            bool turns =
                (samples[i].slope < 0 && samples[i + 1].slope >= 0) || (samples[i].slope == 0 && samples[i + 1].slope > 0);
            if (turns && !has_peak_within(workspace, low, high))
                workspace->peaks[workspace->peak_count++] = solve_slope(workspace->solver, f, low, high);
        }
        if (handled == workspace->peak_count) return;
        for (; handled < workspace->peak_count; handled++) {
            double peak = workspace->peaks[handled];
            double first_step = 2 * sample_integrand(f, peak).distance / ray_length;
            add_sample(workspace, f, peak, end);
            add_break_point(workspace, peak, end);
            for (int side = -1; side <= 1; side += 2)
                for (double step = first_step; step < end; step *= 4) {
                    double x = peak + side * step;
                    if (x <= 0 || x >= end) break;
                    add_sample(workspace, f, x, end);
                    add_break_point(workspace, x, end);
                }
        }
    }
}

/* Adds a break point at every change of label between two samples. What a misplaced one costs is the product of its error
 * and the jump, or the product of its error's square and the change of slope: bisection ends soon for a kink, late for a jump.
 * Between two samples that are dark there may be light. `estimate` is about the integral's value. */
static void find_changes(reference_workspace *workspace, const integrand *f, sample low, sample high, double end,
                         double estimate)
{
    if (low.label == high.label) return;
    double width = high.x - low.x;
    if ((width * fabs(high.value - low.value) <= 1e-13 * estimate && width * high.most <= 1e-7 * estimate) ||
        width <= 1e-15 * end) {
        add_break_point(workspace, 0.5 * (low.x + high.x), end);
        return;
    }
    if (workspace->break_point_count >= MAX_BREAK_POINTS - 2) return;
    sample middle = sample_integrand(f, 0.5 * (low.x + high.x));
    find_changes(workspace, f, low, middle, end, estimate);
    find_changes(workspace, f, middle, high, end, estimate);
}

/* Fills the workspace's break points, with 0 and `end` among them, sorted. Moves the integrand's origin to the narrowest peak
 * and measures the break points from there. */
static void find_break_points(reference_workspace *workspace, integrand *f, double end)
{
    workspace->sample_count = workspace->peak_count = workspace->break_point_count = 0;
    for (int i = 0; i < UNIFORM_SAMPLES; i++)
        add_sample(workspace, f, end * i / (UNIFORM_SAMPLES - 1), end);
    add_seeds(workspace, f, end);
    find_peaks(workspace, f, end);
    /* Between two closest approaches within a core, the ray may leave it for a moment. */
    for (size_t i = 0, count = workspace->sample_count; i + 1 < count; i++) {
        const sample *low = &workspace->samples[i], *high = &workspace->samples[i + 1];
        if (low->slope > 0 && high->slope < 0)
            add_sample(workspace, f, solve_slope(workspace->solver, f, low->x, high->x), end);
    }

    /* The decay's own singularity is at s = -beta. */
    for (double s_plus_beta = 4 * f->beta; s_plus_beta < end + f->beta; s_plus_beta *= 4)
        add_break_point(workspace, s_plus_beta - f->beta, end);
    /* The distance to a torus has a kink where the ray meets the axis. */
    if (f->source.kind == TORUS) {
        double across[3], height = dot(f->direction, f->source.axis);
        add_scaled(f->direction, -height, f->source.axis, across);
        double square = dot(across, across);
        if (square > 0) add_break_point(workspace, dot(across, f->source.position) / square, end);
    }
    qsort(workspace->samples, workspace->sample_count, sizeof(sample), compare_samples);
    const sample *samples = workspace->samples;
    double estimate = 0;
    for (size_t i = 0; i + 1 < workspace->sample_count; i++)
        estimate += 0.5 * (samples[i].value + samples[i + 1].value) * (samples[i + 1].x - samples[i].x);
    for (size_t i = 0; i + 1 < workspace->sample_count; i++)
        find_changes(workspace, f, samples[i], samples[i + 1], end, estimate);

    size_t closest = 0;
    for (size_t i = 1; i < workspace->sample_count; i++)
        if (samples[i].distance < samples[closest].distance) closest = i;
    double origin = samples[closest].x;
    set_origin(f, origin);
    workspace->break_points[workspace->break_point_count++] = 0;
    workspace->break_points[workspace->break_point_count++] = end;
    for (size_t i = 0; i < workspace->break_point_count; i++)
        workspace->break_points[i] -= origin;
    qsort(workspace->break_points, workspace->break_point_count, sizeof(double), compare_numbers);
}

/* ---- The integral ---------------------------------------------------------------------------------------------------------
 */

static quadrature_panel integrate_panel(const gsl_function *function, double low, double high)
{
    quadrature_panel panel = {.low = low, .high = high};
    double absolute, variation;
    gsl_integration_qk21(function, low, high, &panel.value, &panel.error, &absolute, &variation);
    return panel;
}

/* QUADPACK's global strategy: bisect the panel with the largest error until the sum of the errors is small. QAGP does so too,
 * but also extrapolates, which near-jumps (the nearest point rushing around a narrow bend) lead astray. */
static reference_value integrate(reference_workspace *workspace, integrand *f, double end)
{
    if (end <= 0 || f->source.coefficient == 0 || f->alpha == 0) return (reference_value){0};
    find_break_points(workspace, f, end);
    gsl_function function = {integrand_value, f};
    quadrature_panel *panels = workspace->panels;
    size_t count = workspace->break_point_count - 1;
    for (size_t i = 0; i < count; i++)
        panels[i] = integrate_panel(&function, workspace->break_points[i], workspace->break_points[i + 1]);
    for (;;) {
        reference_value sum = {0};
        size_t worst = 0;
        for (size_t i = 0; i < count; i++) {
            sum.luminance += panels[i].value;
            sum.error += panels[i].error;
            if (panels[i].error > panels[worst].error) worst = i;
        }
        double low = panels[worst].low, high = panels[worst].high, middle = 0.5 * (low + high);
        if (sum.error <= 1e-10 * sum.luminance || count == MAX_PANELS || !(low < middle && middle < high)) {
            sum.error += 1e-13 * sum.luminance; /* for the integrand's own rounding */
            return sum;
        }
        panels[worst] = integrate_panel(&function, low, middle);
        panels[count++] = integrate_panel(&function, middle, high);
    }
}

static integrand make_integrand(source_kind kind, const double position[3], const double axis[3], double coefficient,
                                const reference_ray *ray, double epsilon)
{
    integrand f = {
        .source = {.kind = kind, .coefficient = coefficient},
        .alpha = ray->decay_alpha,
        .beta = ray->decay_beta,
        .epsilon = epsilon,
    };
    long double square = 0;
    for (int i = 0; i < 3; i++) {
        f.exact_direction[i] = (long double)ray->end[i] - ray->start[i];
        f.direction[i] = (double)f.exact_direction[i];
        f.position_from_start[i] = (long double)position[i] - ray->start[i];
        if (axis) square += (long double)axis[i] * axis[i];
    }
    for (int i = 0; axis && i < 3; i++) {
        f.exact_axis[i] = axis[i] / sqrtl(square);
        f.source.axis[i] = (double)f.exact_axis[i];
    }
    set_origin(&f, 0);
    return f;
}

bool reference_luminance(reference_workspace *workspace, const ew_sources_desc *sources, const reference_ray *ray,
                         reference_value *sum, reference_value *shares)
{
    *sum = (reference_value){0};
    size_t lines = sources->point_count, tori = lines + sources->line_count, curves = tori + sources->torus_count;
    for (size_t i = 0; i < curves + sources->curve_count; i++) {
        integrand f;
        if (i < lines) {
            const ew_point *point = &sources->points[i];
            f = make_integrand(POINT, point->position, NULL, point->coefficient, ray, sources->epsilon);
        } else if (i < tori) {
            const ew_line *line = &sources->lines[i - lines];
            f = make_integrand(LINE, line->position, line->direction, line->coefficient, ray, sources->epsilon);
        } else if (i < curves) {
            const ew_torus *torus = &sources->tori[i - tori];
            f = make_integrand(TORUS, torus->center, torus->axis, torus->coefficient, ray, sources->epsilon);
            f.source.radius = torus->radius;
        } else {
            const ew_curve *curve = &sources->curves[i - curves];
            f = make_integrand(CURVE, curve->polynomial[0], NULL, curve->coefficient, ray, sources->epsilon);
            f.source.curve = curve;
        }
        reference_value share = integrate(workspace, &f, ray->s_max);
        sum->luminance += share.luminance;
        sum->error += share.error;
        if (shares) shares[i] = share;
    }
    return sum->error <= REFERENCE_RELATIVE_ERROR * sum->luminance;
}
