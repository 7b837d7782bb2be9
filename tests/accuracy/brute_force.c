/* Luminances by brute force: see brute_force.h. */
#include "brute_force.h"
#include "brute_force_path.h"
#include "source_kinds.h"

#include <math.h>

/* ---- Curves ------------------------------------------------------------------------------------------------------------- */

long double brute_force_square_distance_at(const ew_curve *curve, const long double p[3], long double t)
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
    long double square = brute_force_square_distance_at(curve, p, t);
    if (!(square < *best)) return;
    *best = square;
    *best_t = t;
}

/* Half the derivative of the squared distance by t: the cubic (12), from its constant on. */
static void slope_cubic(const ew_curve *curve, const long double p[3], long double cubic[4])
{
    for (int k = 0; k < 4; k++)
        cubic[k] = 0;
    for (int i = 0; i < 3; i++) {
        long double c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i], c0 = curve->polynomial[0][i] - p[i];
        cubic[0] += c0 * c1;
        cubic[1] += c1 * c1 + 2 * c0 * c2;
        cubic[2] += 3 * c1 * c2;
        cubic[3] += 2 * c2 * c2;
    }
}

/* Cardano's formula. Returns how many real roots there are. */
static int cubic_roots(const long double cubic[4], long double roots[3])
{
    const long double third_of_turn = 2.0943951023931954923L;
    if (!(cubic[3] > 0)) return 0;
    long double shift = -cubic[2] / (3 * cubic[3]);
    long double slope = cubic[1] / cubic[3] - 3 * shift * shift;
    long double constant = cubic[0] / cubic[3] + shift * (cubic[1] / cubic[3] + shift * (cubic[2] / cubic[3] + shift));
    long double r = constant * constant / 4 + slope * slope * slope / 27;
    if (r >= 0) {
        roots[0] = cbrtl(-constant / 2 + sqrtl(r)) + cbrtl(-constant / 2 - sqrtl(r)) + shift;
        return 1;
    }
    long double angle = atan2l(sqrtl(-r), -constant / 2) / 3;
    for (int k = 0; k < 3; k++)
        roots[k] = 2 * sqrtl(-slope / 3) * cosl(angle + k * third_of_turn) + shift;
    return 3;
}

static long double polish_root(const long double cubic[4], long double t)
{
    for (int step = 0; step < 8; step++) {
        long double value = cubic[0] + t * (cubic[1] + t * (cubic[2] + t * cubic[3]));
        long double derivative = cubic[1] + t * (2 * cubic[2] + t * 3 * cubic[3]);
        if (derivative > 0) t -= value / derivative;
    }
    return t;
}

long double brute_force_curve_distance(const ew_curve *curve, const long double p[3], long double *nearest_t)
{
    enum { STEPS = 32 };
    long double cubic[4], best = HUGE_VALL, starts[4];
    for (int i = 0; i <= STEPS; i++) {
        long double t = curve->domain[0] + ((long double)curve->domain[1] - curve->domain[0]) * i / STEPS;
        try_parameter(curve, p, t, &best, nearest_t);
    }
    slope_cubic(curve, p, cubic);
    starts[0] = *nearest_t;
    int count = 1 + cubic_roots(cubic, starts + 1);
    for (int i = 0; i < count; i++)
        try_parameter(curve, p, polish_root(cubic, starts[i]), &best, nearest_t);
    return sqrtl(best);
}

/* The weight by de Boor's algorithm (not by the basis functions). */
long double brute_force_weight(const double *w, size_t n, long double u)
{
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

/* ---- Every kind ---------------------------------------------------------------------------------------------------------- */

typedef long double distance_function(const void *source, const long double p[3], long double *weight);

/* Splits the way from `center` to p into the part along `axis` and the part across it. */
static void split(const double center[3], const double axis[3], const long double p[3], long double *along, long double *across)
{
    long double from[3], radial[3], norm = hypotl(hypotl(axis[0], axis[1]), axis[2]);
    for (int i = 0; i < 3; i++)
        from[i] = p[i] - center[i];
    *along = (from[0] * axis[0] + from[1] * axis[1] + from[2] * axis[2]) / norm;
    for (int i = 0; i < 3; i++)
        radial[i] = from[i] - *along * axis[i] / norm;
    *across = hypotl(hypotl(radial[0], radial[1]), radial[2]);
}

static long double distance_to_point(const void *source, const long double p[3], long double *weight)
{
    const ew_point *point = source;
    (void)weight;
    return hypotl(hypotl(p[0] - point->position[0], p[1] - point->position[1]), p[2] - point->position[2]);
}

static long double distance_to_line(const void *source, const long double p[3], long double *weight)
{
    const ew_line *line = source;
    long double along, across;
    (void)weight;
    split(line->position, line->direction, p, &along, &across);
    return across;
}

static long double distance_to_torus(const void *source, const long double p[3], long double *weight)
{
    const ew_torus *torus = source;
    long double height, from_axis;
    (void)weight;
    split(torus->center, torus->axis, p, &height, &from_axis);
    return hypotl(from_axis - torus->radius, height);
}

static long double distance_to_curve(const void *source, const long double p[3], long double *weight)
{
    const ew_curve *curve = source;
    long double t = 0, distance = brute_force_curve_distance(curve, p, &t);
    long double u = (t - curve->domain[0]) / ((long double)curve->domain[1] - curve->domain[0]);
    *weight = brute_force_weight(curve->weights, curve->weight_count, u);
    return distance;
}

/* A weight that is not 1 is told besides. */
static distance_function *const distances[SOURCE_KIND_COUNT] = {
    [KIND_POINT] = distance_to_point,
    [KIND_LINE] = distance_to_line,
    [KIND_TORUS] = distance_to_torus,
    [KIND_CURVE] = distance_to_curve,
};

/* ---- Quadrature --------------------------------------------------------------------------------------------------------- */

typedef struct brute_force {
    const ew_sources_desc *sources; /* a single one */
    int kind;
    brute_force_light light;
    const reference_ray *ray;
} brute_force;

/* 1 / max(r', d) - 1 / R, or 0 beyond the reach: by the definitions in energywave.h. */
long double brute_force_glow(const brute_force_light *light, long double distance)
{
    long double floored = fmaxl(light->core, distance);
    return light->reach == 0 ? 1 / floored : fmaxl(0, 1 / floored - 1 / light->reach);
}

/* What does not change along the ray: the coefficient, and the core as the world has it. */
static brute_force_light light_of(const source_light *light, double epsilon)
{
    brute_force_light result = {light->coefficient, light->core > 0 ? light->core : epsilon, light->reach};
    if (light->brightness > 0) result.coefficient = light->brightness / (2 * logl(result.reach / result.core));
    return result;
}

static long double brute_force_field(const brute_force *f, const brute_force_light *light, const long double p[3])
{
    const void *source = source_at(source_kinds[f->kind], f->sources, 0);
    if (f->kind == KIND_PATH) return brute_force_path_field(source, light, p);
    long double weight = 1, distance = distances[f->kind](source, p, &weight);
    return weight * brute_force_glow(light, distance);
}

static long double brute_force_integrand(const brute_force *f, long double s)
{
    const reference_ray *ray = f->ray;
    brute_force_light light = f->light;
    long double p[3], direction[3], s_plus_beta = s + ray->decay_beta;
    for (int i = 0; i < 3; i++) {
        direction[i] = (long double)ray->end[i] - ray->start[i];
        p[i] = ray->start[i] + s * direction[i];
    }
    light.core = hypotl(light.core, (1 - s) * ray->least_core[0] + s * ray->least_core[1]);
    long double dx = hypotl(hypotl(direction[0], direction[1]), direction[2]);
    return light.coefficient * brute_force_field(f, &light, p) *
           (ray->is_world ? dx : ray->decay_alpha / (s_plus_beta * s_plus_beta));
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

/* Bisects until the halves agree with the whole twice in a row, knowing nothing of the integrand. */
static long double bisect(const brute_force *f, long double a, long double b, long double whole, long double negligible,
                          bool agreed)
{
    long double middle = 0.5L * (a + b), left = lobatto(f, a, middle), right = lobatto(f, middle, b), halves = left + right;
    bool agrees = fabsl(halves - whole) <= 0.1L * BRUTE_FORCE_ERROR * halves + negligible;
    if (agrees && agreed) return halves;
    return bisect(f, a, middle, left, negligible, agrees) + bisect(f, middle, b, right, negligible, agrees);
}

double brute_force_luminance(const ew_sources_desc *sources, const reference_ray *ray)
{
    enum { PANELS = 64 };
    brute_force f = {.sources = sources, .ray = ray};
    while (source_count(source_kinds[f.kind], sources) == 0)
        f.kind++;
    const source_kind *kind = source_kinds[f.kind];
    source_light light = source_light_of(kind, source_at(kind, sources, 0));
    f.light = light_of(&light, sources->epsilon);
    long double ends[PANELS + 1], parts[PANELS], rough = 0, sum = 0;
    for (int i = 0; i <= PANELS; i++)
        ends[i] = (long double)ray->s_max * i / PANELS;
    for (int i = 0; i < PANELS; i++)
        rough += parts[i] = lobatto(&f, ends[i], ends[i + 1]);
    for (int i = 0; i < PANELS; i++)
        sum += bisect(&f, ends[i], ends[i + 1], parts[i], 1e-13L * rough + 1e-14L * f.light.coefficient, false);
    return (double)fmaxl(0, sum);
}
