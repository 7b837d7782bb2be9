/* Where to divide a ray: see break_points.h. */
#include "break_points.h"
#include "sort.h"
#include "source_kinds.h"
#include "vector.h"

#include <gsl/gsl_errno.h>
#include <stdlib.h>

enum { UNIFORM_SAMPLES = 17 };

static int compare_samples(const void *a, const void *b)
{
    const integrand_sample *first = a, *second = b;
    return (first->x > second->x) - (first->x < second->x);
}

static void sort_samples(break_point_search *search)
{
    qsort(search->samples, search->sample_count, sizeof *search->samples, compare_samples);
}

/* Adds a sample where x is within the ray's range. */
static void add_sample(break_point_search *search, const integrand *f, double x, double end)
{
    if (x >= 0 && x <= end && search->sample_count < MAX_SAMPLES) search->samples[search->sample_count++] = integrand_at(f, x);
}

static void add_break_point(break_point_search *search, double x, double end)
{
    if (x > 0 && x < end && search->break_point_count < MAX_BREAK_POINTS - 2)
        search->break_points[search->break_point_count++] = x;
}

/* ---- Peaks -------------------------------------------------------------------------------------------------------------- */

/* Samples where the ray comes nearest to some points of the source, so that a source that is short along the ray is seen. */
static void add_seeds(break_point_search *search, const integrand *f, double end)
{
    const source_kind *kind = f->source.kind;
    for (int i = 0; i < (kind->seed ? kind->seed_count : 1); i++) {
        double seed[3];
        vector_copy(f->source.position, seed);
        if (kind->seed) kind->seed(&f->source, i, seed);
        add_sample(search, f, vector_dot(seed, f->direction) / vector_dot(f->direction, f->direction), end);
    }
}

static bool has_peak_within(const break_point_search *search, double low, double high)
{
    for (size_t i = 0; i < search->peak_count; i++)
        if (search->peaks[i] >= low && search->peaks[i] <= high) return true;
    return false;
}

static double distance_slope(double x, void *f)
{
    return integrand_distance_slope(f, x);
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

/* The ends of the ray where the distance grows inwards. The samples are sorted. */
static void find_peaks_at_the_ends(break_point_search *search, double end)
{
    if (search->samples[0].slope >= 0) search->peaks[search->peak_count++] = 0;
    if (search->samples[search->sample_count - 1].slope <= 0) search->peaks[search->peak_count++] = end;
}

/* Wherever the sorted samples show that the distance's slope turns from negative to positive. */
static void find_peaks_between_samples(break_point_search *search, integrand *f)
{
    const integrand_sample *samples = search->samples;
    for (size_t i = 0; i + 1 < search->sample_count && search->peak_count < MAX_PEAKS; i++) {
        double low = samples[i].x, high = samples[i + 1].x;
        bool turns = (samples[i].slope < 0 && samples[i + 1].slope >= 0) || (samples[i].slope == 0 && samples[i + 1].slope > 0);
        if (turns && !has_peak_within(search, low, high))
            search->peaks[search->peak_count++] = solve_slope(search->solver, f, low, high);
    }
}

/* Adds samples and break points at a peak and, in geometric progression from its own distance on, on either side: between two
 * of them the singularities of 1/distance stay well off the panel. */
static void surround_peak(break_point_search *search, const integrand *f, double peak, double end)
{
    double first_step = 2 * integrand_at(f, peak).distance / vector_length(f->direction);
    add_sample(search, f, peak, end);
    add_break_point(search, peak, end);
    for (int side = -1; side <= 1; side += 2)
        for (double step = first_step; step < end; step *= 4) {
            double x = peak + side * step;
            if (x <= 0 || x >= end) break;
            add_sample(search, f, x, end);
            add_break_point(search, x, end);
        }
}

/* Finds the closest approaches. Every new one brings new samples, which may show another one. */
static void find_peaks(break_point_search *search, integrand *f, double end)
{
    for (size_t handled = 0;;) {
        sort_samples(search);
        if (handled == 0) find_peaks_at_the_ends(search, end);
        find_peaks_between_samples(search, f);
        if (handled == search->peak_count) return;
        for (; handled < search->peak_count; handled++)
            surround_peak(search, f, search->peaks[handled], end);
    }
}

/* Between two closest approaches within a core, the ray may leave it for a moment. */
static void sample_between_peaks(break_point_search *search, integrand *f, double end)
{
    for (size_t i = 0, count = search->sample_count; i + 1 < count; i++) {
        const integrand_sample *low = &search->samples[i], *high = &search->samples[i + 1];
        if (low->slope > 0 && high->slope < 0) add_sample(search, f, solve_slope(search->solver, f, low->x, high->x), end);
    }
}

/* ---- Kinks and jumps ---------------------------------------------------------------------------------------------------- */

/* Those that no sample shows. */
static void add_known_break_points(break_point_search *search, const integrand *f, double end)
{
    const source_kind *kind = f->source.kind;
    double x;
    /* The decay's own singularity is at s = -beta. */
    for (double s_plus_beta = 4 * f->beta; !f->is_world && s_plus_beta < f->origin_s + end + f->beta; s_plus_beta *= 4)
        add_break_point(search, s_plus_beta - f->beta - f->origin_s, end);
    if (kind->kink && kind->kink(&f->source, f->direction, &x)) add_break_point(search, x, end);
    for (size_t i = 0; i < f->fog.body_count; i++) {
        add_break_point(search, f->fog.bodies[i].from - f->origin_s, end);
        add_break_point(search, f->fog.bodies[i].to - f->origin_s, end);
    }
}

/* About the integral's value. The samples are sorted. */
static double estimate_integral(const break_point_search *search)
{
    const integrand_sample *samples = search->samples;
    double estimate = 0;
    for (size_t i = 0; i + 1 < search->sample_count; i++)
        estimate += 0.5 * (samples[i].value + samples[i + 1].value) * (samples[i + 1].x - samples[i].x);
    return estimate;
}

/* Adds a break point at every change of label between two samples. What a misplaced one costs is the product of its error
 * and the jump, or the product of its error's square and the change of slope: bisection ends soon for a kink, late for a jump.
 * Between two samples whose weights are 0 there may be light, but not between two beyond the reach. `estimate` is about the
 * integral's value. */
static void find_changes(break_point_search *search, const integrand *f, integrand_sample low, integrand_sample high,
                         double end, double estimate)
{
    if (low.label == high.label || (low.is_dark && high.is_dark)) return;
    double width = high.x - low.x;
    if ((width * fabs(high.value - low.value) <= 1e-13 * estimate && width * high.most <= 1e-7 * estimate) ||
        width <= 1e-15 * end) {
        add_break_point(search, 0.5 * (low.x + high.x), end);
        return;
    }
    if (search->break_point_count >= MAX_BREAK_POINTS - 2) return;
    integrand_sample middle = integrand_at(f, 0.5 * (low.x + high.x));
    find_changes(search, f, low, middle, end, estimate);
    find_changes(search, f, middle, high, end, estimate);
}

/* ---- All of them -------------------------------------------------------------------------------------------------------- */

/* Adds break points to the part from low to high, until none is as long as an optical depth. */
static void divide_by_fog(break_point_search *search, const integrand *f, double low, double high)
{
    double before = integrand_optical_depth(f, low), middle = 0.5 * (low + high);
    if (integrand_optical_depth(f, high) - before <= 1 || before > REFERENCE_FOG_DEPTH) return;
    if (!(low < middle && middle < high) || search->break_point_count >= MAX_BREAK_POINTS - 2) return;
    add_break_point(search, middle, high);
    divide_by_fog(search, f, low, middle);
    divide_by_fog(search, f, middle, high);
}

/* Adds the ray's ends, and measures all from the closest sample on. */
static void finish(break_point_search *search, integrand *f, double end)
{
    size_t closest = 0;
    for (size_t i = 1; i < search->sample_count; i++)
        if (search->samples[i].distance < search->samples[closest].distance) closest = i;
    double origin = search->samples[closest].x;
    integrand_set_origin(f, f->origin_s + origin);
    search->break_points[search->break_point_count++] = 0;
    search->break_points[search->break_point_count++] = end;
    for (size_t i = 0; i < search->break_point_count; i++)
        search->break_points[i] -= origin;
    sort_numbers(search->break_points, search->break_point_count);
}

static bool is_dark(const break_point_search *search)
{
    for (size_t i = 0; i < search->sample_count; i++)
        if (!search->samples[i].is_dark) return false;
    return true;
}

void break_points_find(break_point_search *search, integrand *f, double end)
{
    search->sample_count = search->peak_count = search->break_point_count = 0;
    for (int i = 0; i < UNIFORM_SAMPLES; i++)
        add_sample(search, f, end * i / (UNIFORM_SAMPLES - 1), end);
    add_seeds(search, f, end);
    find_peaks(search, f, end);
    /* The closest approaches are among the samples. */
    if (is_dark(search)) return;
    sample_between_peaks(search, f, end);

    add_known_break_points(search, f, end);
    sort_samples(search);
    double estimate = estimate_integral(search);
    for (size_t i = 0; i + 1 < search->sample_count; i++)
        find_changes(search, f, search->samples[i], search->samples[i + 1], end, estimate);
    divide_by_fog(search, f, 0, end);
    finish(search, f, end);
}
