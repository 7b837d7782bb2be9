/* Curves, with weights and without: see source_kind.h. */
#include "random_numbers.h"
#include "reference_arc.h"
#include "reference_weight.h"
#include "source_kinds.h"
#include "vector.h"

enum { SEED_COUNT = 9 };

/* ---- The reference ------------------------------------------------------------------------------------------------------ */

/* From C0. */
static double extent(const void *source)
{
    const ew_curve *curve = source;
    double t = fmax(fabs(curve->domain[0]), fabs(curve->domain[1]));
    return t * (vector_length(curve->polynomial[1]) + t * vector_length(curve->polynomial[2]));
}

static nearest_point nearest(const reference_source *source, const double point[3])
{
    double from[3];
    vector_subtract(source->position, point, from);
    return reference_nearest_of_arc(source->desc, from);
}

static reference_weighting weigh(const reference_source *source, const nearest_point *nearest)
{
    const ew_curve *curve = source->desc;
    double u = (nearest->t - curve->domain[0]) / (curve->domain[1] - curve->domain[0]), largest = 1;
    for (size_t i = 0; i < curve->weight_count; i++)
        largest = i == 0 ? curve->weights[i] : fmax(largest, curve->weights[i]);
    return (reference_weighting){
        .weight = reference_weight(curve->weights, curve->weight_count, u),
        .largest = largest,
        .span = reference_weight_span(curve->weight_count, u),
    };
}

/* The point at t of the arc, whose C0 is at `start`. */
static void point_at(const ew_curve *curve, const double start[3], double t, double result[3])
{
    vector_add_scaled(start, t, curve->polynomial[1], result);
    vector_add_scaled(result, t * t, curve->polynomial[2], result);
}

static void seed(const reference_source *source, int number, double result[3])
{
    const ew_curve *curve = source->desc;
    double t = curve->domain[0] + number / (SEED_COUNT - 1.0) * (curve->domain[1] - curve->domain[0]);
    point_at(curve, source->position, t, result);
}

/* ---- Random scenes ------------------------------------------------------------------------------------------------------ */

static void place(const void *source, const source_view *view, double u, double result[3])
{
    const ew_curve *curve = source;
    (void)view;
    point_at(curve, curve->polynomial[0], curve->domain[0] + u * (curve->domain[1] - curve->domain[0]), result);
}

/* A parabola about its vertex, with `points` for C1 and C2. */
static void bend_about_the_vertex(scene_maker *maker, double points[3][3], double polynomial[3][3], double domain[2])
{
    double width = maker_magnitude(maker, 1e-4, 1);
    for (int i = 0; i < 3; i++) {
        polynomial[1][i] = width * points[1][i];
        polynomial[2][i] = points[2][i];
    }
    domain[0] = maker_between(maker, -1, 0.5);
    domain[1] = 1;
}

static void piece_far_from_the_vertex(scene_maker *maker, double points[3][3], double polynomial[3][3], double domain[2])
{
    double length = maker_magnitude(maker, 1e-2, 1), start = maker_between(maker, -20, 20);
    for (int i = 0; i < 3; i++) {
        polynomial[1][i] = points[1][i] / length - 2 * start * points[2][i];
        polynomial[2][i] = points[2][i];
    }
    domain[0] = start;
    domain[1] = start + length;
}

/* Equation (10). */
static void bezier(double points[3][3], double polynomial[3][3], double domain[2])
{
    vector_copy(points[0], polynomial[0]);
    for (int i = 0; i < 3; i++) {
        polynomial[1][i] = 2 * (points[1][i] - points[0][i]);
        polynomial[2][i] = points[0][i] - 2 * points[1][i] + points[2][i];
    }
    domain[0] = 0;
    domain[1] = 1;
}

/* A parabola's polynomial, but for where it is, and its domain. */
static void random_arc(scene_maker *maker, double polynomial[3][3], double domain[2])
{
    double extent = maker_source_extent(maker), points[3][3], shape = maker_between(maker, 0, 1);
    for (int i = 0; i < 3; i++)
        maker_offset(maker, extent, points[i]);
    if (shape >= 0.25 && shape < 0.3) {
        piece_far_from_the_vertex(maker, points, polynomial, domain);
        return;
    }
    if (shape >= 0.15 && shape < 0.25) {
        bend_about_the_vertex(maker, points, polynomial, domain);
        return;
    }
    if (shape < 0.1) { /* nearly straight */
        double bend = maker_magnitude(maker, 1e-7, 1e-1);
        for (int i = 0; i < 3; i++)
            points[1][i] = 0.5 * (points[0][i] + points[2][i]) + bend * points[1][i];
    } else if (shape < 0.15) { /* two points coincide */
        vector_copy(points[maker_chance(maker, 0.5) ? 0 : 2], points[1]);
    }
    bezier(points, polynomial, domain);
}

static void write(scene_maker *maker, bool first, bool weighted)
{
    double polynomial[3][3], domain[2], position[3];
    random_arc(maker, polynomial, domain);
    maker_source_place(maker, first, position);
    /* Ends are looked at more often than their share. */
    double t = maker_chance(maker, 0.3) ? domain[maker_chance(maker, 0.5)] : maker_between(maker, domain[0], domain[1]);
    for (int i = 0; i < 3; i++)
        polynomial[0][i] = position[i] - t * (polynomial[1][i] + t * polynomial[2][i]);
    fputs("\"polynomial\": [", maker->file);
    for (int i = 0; i < 3; i++)
        fprintf(maker->file, "[%.17g, %.17g, %.17g]%s", polynomial[i][0], polynomial[i][1], polynomial[i][2],
                i < 2 ? ", " : "");
    fprintf(maker->file, "], \"domain\": [%.17g, %.17g], ", domain[0], domain[1]);
    if (weighted) maker_write_weights(maker, false);
}

/* ---- Hostile input ------------------------------------------------------------------------------------------------------ */

/* Brings control points to one of the shapes at which a curve degenerates, or leaves them as they are. */
static void degenerate(uint64_t *random, double points[3][3])
{
    double fold = random_between(random, -1, 2), close = random_power_of_ten(random, -12, 0);
    enum { STRAIGHT, NEARLY_STRAIGHT, COINCIDENT, HAIRPIN, SHAPE_COUNT = 6 };
    size_t shape = random_index(random, SHAPE_COUNT);
    for (int i = 0; i < 3; i++) {
        double *first = &points[0][i], *middle = &points[1][i], *last = &points[2][i];
        if (shape == STRAIGHT) *middle = *first + fold * (*last - *first); /* or folded back on itself */
        if (shape == NEARLY_STRAIGHT) *middle = *first / 2 + *last / 2 + close * (*middle - *first);
        if (shape == COINCIDENT) { /* two of them or all, or nearly so */
            *middle = *first + close * (*middle - *first);
            if (fold < 0) *last = *first;
        }
        if (shape == HAIRPIN) *last = *first + close * (*last - *first);
    }
}

static void make(const random_place *at, void *source, double *weights, double (*points)[3])
{
    ew_curve *curve = source;
    double control[3][3];
    (void)points;
    for (int i = 0; i < 3; i++)
        random_position(at, control[i]);
    if (at->extreme) degenerate(at->random, control);
    bezier(control, curve->polynomial, curve->domain);
    if (at->extreme && random_chance(at->random, 0.2)) {
        curve->domain[0] = random_between(at->random, -2, 2);
        curve->domain[1] = curve->domain[0] + random_power_of_ten(at->random, -6, 1);
    }
    random_light(at, &curve->coefficient, curve->color);
    curve->weights = weights;
    if (weights) curve->weight_count = random_weights(at, weights);
}

static size_t numbers(void *source, number_run runs[MAX_SOURCE_RUNS])
{
    ew_curve *curve = source;
    size_t count = 0;
    runs[count++] = (number_run){&curve->polynomial[0][0], 9};
    runs[count++] = (number_run){curve->domain, 2};
    runs[count++] = (number_run){&curve->coefficient, sizeof(source_light) / sizeof(double)};
    /* The library's weights are constants; these are the caller's. */
    runs[count++] = (number_run){(double *)curve->weights, curve->weight_count};
    return count;
}

const source_kind curve_kind = {
    .name = "curve",
    .list_name = "curves",
    SOURCE_KIND_LAYOUT(ew_curve, curves, curve_count, polynomial[0]),
    .direction_offsets = {offsetof(ew_curve, polynomial[1]), offsetof(ew_curve, polynomial[2])},
    .direction_count = 2,
    .extent = extent,
    .nearest = nearest,
    .weigh = weigh,
    .seed = seed,
    .seed_count = SEED_COUNT,
    .place = place,
    .scene_share = 0.2,
    .world_scene_name = "world curve",
    .world_scene_share = 0.14,
    .write = write,
    .make = make,
    .numbers = numbers,
};
