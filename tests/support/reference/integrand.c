/* The integrand of one source along one ray: see integrand.h. */
#include "integrand.h"
#include "source_kinds.h"
#include "vector.h"

/* The unit vector along an axis, in extended precision and rounded. */
static void set_axis(integrand *f, const double axis[3])
{
    long double square = 0;
    for (int i = 0; i < 3; i++)
        square += (long double)axis[i] * axis[i];
    for (int i = 0; i < 3; i++) {
        f->exact_axis[i] = axis[i] / sqrtl(square);
        f->source.axis[i] = (double)f->exact_axis[i];
    }
}

integrand integrand_make(const source_kind *kind, const void *source, const integrand_light *light, const reference_ray *ray)
{
    integrand f = {
        .source = {.kind = kind, .desc = source},
        .coefficient = light->coefficient,
        .is_world = ray->is_world,
        .alpha = ray->decay_alpha,
        .beta = ray->decay_beta,
        .core = light->core,
        .reach = light->reach,
        .least_core = ray->least_core[0],
        .least_core_slope = ray->least_core[1] - ray->least_core[0],
        .fog = ray->fog,
    };
    const double *position = source_position(kind, source);
    for (int i = 0; i < 3; i++) {
        f.exact_direction[i] = (long double)ray->end[i] - ray->start[i];
        f.direction[i] = (double)f.exact_direction[i];
        f.position_from_start[i] = (long double)position[i] - ray->start[i];
    }
    if (kind->has_axis) set_axis(&f, source_direction(kind, source, 0));
    integrand_set_origin(&f, 0);
    return f;
}

void integrand_set_origin(integrand *f, double origin_s)
{
    long double position[3], along = 0;
    for (int i = 0; i < 3; i++) {
        position[i] = f->position_from_start[i] - origin_s * f->exact_direction[i];
        along += position[i] * f->exact_axis[i];
    }
    /* Any point of an endless source serves: the nearest keeps the most digits. */
    bool slide = f->source.kind->is_endless;
    for (int i = 0; i < 3; i++)
        f->source.position[i] = (double)(position[i] - (slide ? along * f->exact_axis[i] : 0));
    f->origin_s = origin_s;
}

/* ---- The reach ---------------------------------------------------------------------------------------------------------- */

/* Where the ray enters and leaves the ball of `radius` about the position or, of an endless source, the cylinder. */
static bool limit_to_ball(const integrand *f, long double radius, double *low, double *high)
{
    long double length_square = 0, square = 0, along = 0, from_square = 0, direction_axis = 0, position_axis = 0;
    for (int i = 0; f->source.kind->is_endless && i < 3; i++) {
        direction_axis += f->exact_direction[i] * f->exact_axis[i];
        position_axis += f->position_from_start[i] * f->exact_axis[i];
    }
    long double direction[3], position[3];
    for (int i = 0; i < 3; i++) {
        direction[i] = f->exact_direction[i] - direction_axis * f->exact_axis[i];
        position[i] = f->position_from_start[i] - position_axis * f->exact_axis[i];
        length_square += f->exact_direction[i] * f->exact_direction[i];
        square += direction[i] * direction[i];
        along += direction[i] * position[i];
    }
    /* The axis and the ray's direction are doubles: at a smaller angle they are parallel but for rounding. */
    bool is_parallel = square <= 1e-32L * length_square;
    long double middle = is_parallel ? 0 : along / square;
    for (int i = 0; i < 3; i++)
        from_square += powl(position[i] - middle * direction[i], 2);
    if (from_square >= radius * radius) return false;
    if (is_parallel) return *low < *high;
    long double half = sqrtl((radius * radius - from_square) / square);
    *low = fmax(*low, (double)(middle - half));
    *high = fmin(*high, (double)(middle + half));
    return *low < *high;
}

/* Where pixels are wider than the reach, the core is, too. They grow with s, or not at all. */
static bool limit_to_narrow_pixels(const integrand *f, double *high)
{
    double widest = sqrt((f->reach - f->core) * (f->reach + f->core));
    if (f->least_core_slope > 0) *high = fmin(*high, (widest - f->least_core) / f->least_core_slope);
    return f->least_core_slope > 0 || f->least_core < widest;
}

bool integrand_limit(const integrand *f, double *low, double *high)
{
    const source_kind *kind = f->source.kind;
    double extent = kind->extent ? kind->extent(f->source.desc) : 0;
    if (f->reach == HUGE_VAL) return *low < *high;
    return limit_to_narrow_pixels(f, high) && limit_to_ball(f, (long double)f->reach + extent, low, high);
}

/* ---- The value ---------------------------------------------------------------------------------------------------------- */

/* The core's radius, at least that of the pixels it is seen by. */
static double core_at(const integrand *f, double x)
{
    double least = f->least_core + (f->origin_s + x) * f->least_core_slope;
    return least > 0 ? hypot(f->core, least) : f->core;
}

/* The field times the decay or, in the world integral, times dx / ds. */
static double times_decay(const integrand *f, double field, double x)
{
    double s_plus_beta = f->origin_s + x + f->beta;
    return f->is_world ? field * vector_length(f->direction) : field * f->alpha / (s_plus_beta * s_plus_beta);
}

static nearest_point nearest_at(const integrand *f, double x)
{
    double point[3];
    for (int i = 0; i < 3; i++)
        point[i] = x * f->direction[i];
    return f->source.kind->nearest(&f->source, point);
}

integrand_sample integrand_at(const integrand *f, double x)
{
    const source_kind *kind = f->source.kind;
    nearest_point nearest = nearest_at(f, x);
    reference_weighting weighting = {.weight = 1, .largest = 1};
    if (kind->weigh) weighting = kind->weigh(&f->source, &nearest);
    double core = core_at(f, x), distance = fmax(core, nearest.distance);
    bool inside_core = nearest.distance < core, is_dark = nearest.distance >= f->reach;
    double field = distance >= f->reach ? 0 : f->coefficient / distance - f->coefficient / f->reach;
    double unweighted = times_decay(f, field, x);
    double slope = vector_dot(f->direction, nearest.offset);
    double noise = 1e-9 * vector_length(f->direction) * nearest.distance;
    return (integrand_sample){
        .x = x,
        .slope = slope > noise    ? 1
                 : slope < -noise ? -1
                                  : 0,
        .distance = distance,
        .value = weighting.weight * unweighted,
        .most = weighting.largest * unweighted,
        .is_dark = is_dark,
        .label = ((weighting.span * 8 + nearest.piece) * 2 + inside_core) * 2 + is_dark,
    };
}

double integrand_distance_slope(const integrand *f, double x)
{
    nearest_point nearest = nearest_at(f, x);
    return vector_dot(f->direction, nearest.offset);
}

static double optical_depth_of_bodies(const integrand *f, double s)
{
    double sum = 0;
    for (size_t i = 0; i < f->fog.body_count; i++) {
        const reference_body *body = &f->fog.bodies[i];
        sum += body->extinction * fmax(0, fmin(s, body->to) - fmax(f->fog.begin, body->from));
    }
    return sum * vector_length(f->direction);
}

/* The extinction of fog is exp(-height), and height is linear in s: over the way, its mean is (exp(-low) - exp(-high)) /
 * (high - low). */
double integrand_optical_depth(const integrand *f, double x)
{
    const reference_fog *fog = &f->fog;
    double s = f->origin_s + x, way = (s - fog->begin) * vector_length(f->direction), bodies = optical_depth_of_bodies(f, s);
    if (fog->extinction == 0 || !fog->has_height) return fog->extinction * way + bodies;
    double rise = fog->height[1] - fog->height[0], begin = fog->height[0] + fog->begin * rise, end = fog->height[0] + s * rise;
    double low = fmin(begin, end), difference = fabs((s - fog->begin) * rise);
    return fog->extinction * way * exp(-low) * (difference > 0 ? -expm1(-difference) / difference : 1) + bodies;
}
