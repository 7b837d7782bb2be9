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

integrand integrand_make(const source_kind *kind, const void *source, const reference_ray *ray, double epsilon)
{
    integrand f = {
        .source = {.kind = kind, .desc = source},
        .coefficient = source_coefficient(kind, source),
        .alpha = ray->decay_alpha,
        .beta = ray->decay_beta,
        .epsilon = epsilon,
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
    bool inside_core = nearest.distance < f->epsilon;
    double s_plus_beta = f->origin_s + x + f->beta;
    double distance = fmax(f->epsilon, nearest.distance);
    double unweighted = f->coefficient / distance * f->alpha / (s_plus_beta * s_plus_beta);
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
        .label = (weighting.span * 8 + nearest.piece) * 2 + inside_core,
    };
}

double integrand_distance_slope(const integrand *f, double x)
{
    nearest_point nearest = nearest_at(f, x);
    return vector_dot(f->direction, nearest.offset);
}
