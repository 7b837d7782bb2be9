/* Pixels around the sources: see core_pixels.h. */
#include "core_pixels.h"
#include "random_numbers.h"
#include "vector.h"

#include <math.h>

static void place_on_line(const scene_rays *rays, const ew_line *line, double u, double place[3])
{
    /* About the line's point that is nearest to the middle of the view. */
    double middle = 0.5 * (rays->interval_start + rays->interval_end), direction[3], to_middle[3];
    vector_normalize(line->direction, direction);
    for (int i = 0; i < 3; i++)
        to_middle[i] = middle * rays->forward[i] - line->position[i];
    double reach = (2 * u - 1) * (rays->interval_end - rays->interval_start);
    vector_add_scaled(line->position, vector_dot(to_middle, direction) + reach, direction, place);
}

static void place_on_torus(const ew_torus *torus, double u, double place[3])
{
    double axis[3], right[3], up[3];
    vector_normalize(torus->axis, axis);
    double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0};
    vector_cross(axis, other, right);
    vector_normalize(right, right);
    vector_cross(axis, right, up);
    vector_add_scaled(torus->center, torus->radius * cos(2 * M_PI * u), right, place);
    vector_add_scaled(place, torus->radius * sin(2 * M_PI * u), up, place);
}

static void place_on_curve(const ew_curve *curve, double u, double place[3])
{
    double t = curve->domain[0] + u * (curve->domain[1] - curve->domain[0]);
    vector_add_scaled(curve->polynomial[0], t, curve->polynomial[1], place);
    vector_add_scaled(place, t * t, curve->polynomial[2], place);
}

/* A random place on a random source; false if there is none. */
static bool random_place(const scene_rays *rays, uint64_t *random, double place[3])
{
    const ew_sources_desc *sources = &rays->sources;
    size_t lines = sources->point_count, tori = lines + sources->line_count, curves = tori + sources->torus_count;
    size_t count = curves + sources->curve_count, i = random_index(random, count);
    double u = random_unit(random);
    if (count == 0) return false;
    if (i < lines)
        vector_copy(sources->points[i].position, place);
    else if (i < tori)
        place_on_line(rays, &sources->lines[i - lines], u, place);
    else if (i < curves)
        place_on_torus(&sources->tori[i - tori], u, place);
    else
        place_on_curve(&sources->curves[i - curves], u, place);
    return true;
}

bool random_core_pixel(const scene_rays *rays, uint64_t *random, int *x, int *y)
{
    double place[3], column, row, depth;
    if (!random_place(rays, random, place)) return false;
    double distance = 0.25 * pow(128, random_unit(random)), angle = 2 * M_PI * random_unit(random);
    scene_rays_project(rays, place, &column, &row, &depth);
    if (!(depth >= rays->interval_start && depth <= rays->interval_end)) return false;
    column += distance * cos(angle);
    row += distance * sin(angle);
    if (!(column >= 0 && column < rays->width && row >= 0 && row < rays->height)) return false;
    *x = (int)column;
    *y = (int)row;
    return true;
}
