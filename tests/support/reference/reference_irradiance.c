/* See reference_irradiance.h. */
#include "reference_irradiance.h"
#include "path_parts.h"
#include "reference_weight.h"
#include "vector.h"

#include <math.h>

/* Where a shape is at t, and how fast it goes there. */
typedef struct shape_place {
    double position[3];
    double speed;
    double weight;
} shape_place;

/* What is integrated along a shape. */
typedef struct emitter {
    const reference_surface *surface;
    double core, reach;
    bool is_faced;                /* by a surface that turns to every place of the source */
    const reference_gloss *gloss; /* NULL: a diffuse surface */
    void (*at)(const struct emitter *emitter, double t, shape_place *place);
    const void *source;
    size_t span; /* of a path */
} emitter;

static double falloff(const emitter *e, double distance)
{
    double least = fmax(e->core, distance);
    if (least >= e->reach) return 0;
    double root = 1 / least - least / (e->reach * e->reach);
    return root * root;
}

static double light_from(const emitter *e, const double position[3])
{
    double offset[3];
    vector_subtract(position, e->surface->position, offset);
    double distance = vector_length(offset);
    double facing = e->is_faced ? 1 : distance > 0 ? vector_dot(e->surface->normal, offset) / distance : 0;
    if (facing <= 0) return 0;
    if (!e->gloss) return facing * falloff(e, distance);
    double cosine = e->is_faced ? 1 : fmax(0, vector_dot(e->gloss->mirrored, offset)) / distance;
    return (e->gloss->exponent + 1) / (4 * asin(1)) * pow(cosine, e->gloss->exponent) * falloff(e, distance);
}

static double integrand(const emitter *e, double t)
{
    shape_place place;
    e->at(e, t, &place);
    return place.weight * place.speed * light_from(e, place.position);
}

/* Whether a part is short beside the way to its middle or, in the core, beside that: there no peak falls between its places. */
static bool is_short(const emitter *e, double from, double to)
{
    shape_place place;
    double offset[3];
    e->at(e, 0.5 * (from + to), &place);
    vector_subtract(place.position, e->surface->position, offset);
    return place.speed * (to - from) <= 0.5 * fmax(e->core, vector_length(offset));
}

/* ---- Quadrature ---- */

static double refine(const emitter *e, double from, double to, const double f[3], double whole, double tolerance, int depth)
{
    double middle = 0.5 * (from + to), left = 0.5 * (from + middle), right = 0.5 * (middle + to);
    double f_left = integrand(e, left), f_right = integrand(e, right), sixth = (to - from) / 12;
    double first = sixth * (f[0] + 4 * f_left + f[1]), second = sixth * (f[1] + 4 * f_right + f[2]);
    double error = (first + second - whole) / 15;
    if (depth == 0 || (fabs(error) <= tolerance && is_short(e, from, to))) return first + second + error;
    return refine(e, from, middle, (double[]){f[0], f_left, f[1]}, first, 0.5 * tolerance, depth - 1) +
           refine(e, middle, to, (double[]){f[1], f_right, f[2]}, second, 0.5 * tolerance, depth - 1);
}

/* Simpson's rule on short parts, good to 1e-6 of what a surface that turns to all of the source would get. That is found first,
 * by short parts alone. */
static double integrate(emitter *e, double from, double to)
{
    enum { PARTS = 8, DEPTH = 32 };
    double step = (to - from) / PARTS, tolerance = HUGE_VAL, sum = 0;
    for (int pass = 0; pass < 2; pass++) {
        e->is_faced = pass == 0;
        sum = 0;
        for (int i = 0; i < PARTS; i++) {
            double a = from + i * step, b = a + step;
            const double f[3] = {integrand(e, a), integrand(e, 0.5 * (a + b)), integrand(e, b)};
            sum += refine(e, a, b, f, step / 6 * (f[0] + 4 * f[1] + f[2]), tolerance, DEPTH);
        }
        tolerance = 1e-6 * sum / PARTS;
    }
    return sum;
}

/* ---- Shapes ---- */

static void on_line(const emitter *e, double t, shape_place *place)
{
    const ew_line *line = e->source;
    double axis[3], along = 0;
    vector_normalize(line->direction, axis);
    for (int i = 0; i < 3; i++)
        along += (e->surface->position[i] - line->position[i]) * axis[i];
    for (int i = 0; i < 3; i++)
        place->position[i] = line->position[i] + (along + t) * axis[i];
    place->speed = place->weight = 1;
}

static void on_torus(const emitter *e, double t, shape_place *place)
{
    const ew_torus *torus = e->source;
    double axis[3], right[3], up[3];
    vector_normalize(torus->axis, axis);
    vector_across(axis, right, up);
    for (int i = 0; i < 3; i++)
        place->position[i] = torus->center[i] + torus->radius * (cos(t) * right[i] + sin(t) * up[i]);
    place->speed = torus->radius;
    place->weight = 1;
}

static void on_curve(const emitter *e, double t, shape_place *place)
{
    const ew_curve *curve = e->source;
    double slope[3];
    for (int i = 0; i < 3; i++) {
        place->position[i] = (curve->polynomial[2][i] * t + curve->polynomial[1][i]) * t + curve->polynomial[0][i];
        slope[i] = 2 * curve->polynomial[2][i] * t + curve->polynomial[1][i];
    }
    place->speed = sqrt(vector_dot(slope, slope));
    place->weight =
        reference_weight(curve->weights, curve->weight_count, (t - curve->domain[0]) / (curve->domain[1] - curve->domain[0]));
}

static void on_path(const emitter *e, double t, shape_place *place)
{
    const ew_path *path = e->source;
    double p[4][3], slope[3], s = 1 - t;
    path_span(path, e->span, p);
    for (int i = 0; i < 3; i++) {
        place->position[i] = s * s * s * p[0][i] + 3 * s * s * t * p[1][i] + 3 * s * t * t * p[2][i] + t * t * t * p[3][i];
        slope[i] = 3 * (s * s * (p[1][i] - p[0][i]) + 2 * s * t * (p[2][i] - p[1][i]) + t * t * (p[3][i] - p[2][i]));
    }
    place->speed = sqrt(vector_dot(slope, slope));
    place->weight = reference_weight(path->weights, path->weight_count, ((double)e->span + t) / (double)path_span_count(path));
}

/* ---- Sources ---- */

static double coefficient_of(double coefficient, double brightness, double core, double reach)
{
    return brightness > 0 ? brightness / (2 * log(reach / core)) : coefficient;
}

static void add(double light, const double color[3], double irradiance[3])
{
    for (int i = 0; i < 3; i++)
        irradiance[i] += light * color[i];
}

#define CORE(source, sources) ((source)->core > 0 ? (source)->core : (sources)->epsilon)
#define ADD(source, light)                                                                                                     \
    add(coefficient_of((source)->coefficient, (source)->brightness, e.core, (source)->reach) * (light), (source)->color,       \
        irradiance)

void reference_irradiance(const ew_sources_desc *sources, double light_reach, const reference_surface *surface,
                          const reference_gloss *gloss, double irradiance[3])
{
    emitter e = {.surface = surface, .reach = light_reach, .gloss = gloss};
    irradiance[0] = irradiance[1] = irradiance[2] = 0;
    for (size_t i = 0; i < sources->point_count; i++) {
        const ew_point *point = &sources->points[i];
        e.core = CORE(point, sources);
        ADD(point, e.core * light_from(&e, point->position));
    }
    for (size_t i = 0; i < sources->line_count; i++) {
        e.source = &sources->lines[i];
        e.at = on_line;
        e.core = CORE(&sources->lines[i], sources);
        ADD(&sources->lines[i], integrate(&e, -light_reach, light_reach));
    }
    for (size_t i = 0; i < sources->torus_count; i++) {
        e.source = &sources->tori[i];
        e.at = on_torus;
        e.core = CORE(&sources->tori[i], sources);
        ADD(&sources->tori[i], integrate(&e, 0, 2 * acos(-1)));
    }
    for (size_t i = 0; i < sources->curve_count; i++) {
        const ew_curve *curve = &sources->curves[i];
        e.source = curve;
        e.at = on_curve;
        e.core = CORE(curve, sources);
        ADD(curve, integrate(&e, curve->domain[0], curve->domain[1]));
    }
    for (size_t i = 0; i < sources->path_count; i++) {
        const ew_path *path = &sources->paths[i];
        double sum = 0;
        e.source = path;
        e.at = on_path;
        e.core = CORE(path, sources);
        for (e.span = 0; e.span < path_span_count(path); e.span++)
            sum += integrate(&e, 0, 1);
        ADD(path, sum);
    }
}
