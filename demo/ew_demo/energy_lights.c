/* The energy as point lights: see energy_lights.h. */
#include "energy_lights.h"
#include "vector.h"

enum { LIGHTS_OF_A_TORUS = 12, LIGHTS_OF_A_CURVE = 8 };

/* Light per metre of a source and unit of its coefficient. */
static const double brightness = 0.2;

typedef struct light_list {
    energy_light *lights;
    size_t count;
} light_list;

static void add(light_list *list, const double position[3], double radius, double intensity, const double color[3])
{
    if (list->count == ENERGY_MAX_LIGHTS || !(intensity > 0)) return;
    energy_light *light = &list->lights[list->count++];
    vector_copy(position, light->position);
    light->radius = fmax(radius, 0.2);
    for (int i = 0; i < 3; i++)
        light->color[i] = brightness * intensity * color[i];
}

static void add_points(light_list *list, const ew_sources_desc *sources)
{
    for (size_t i = 0; i < sources->point_count; i++)
        add(list, sources->points[i].position, 0.5, 2 * sources->points[i].coefficient, sources->points[i].color);
}

static void add_torus(light_list *list, const ew_torus *torus)
{
    double axis[3], u[3], v[3];
    vector_normalize(torus->axis, axis);
    vector_across(axis, u, v);
    double length = 2 * M_PI * torus->radius / LIGHTS_OF_A_TORUS;
    for (int i = 0; i < LIGHTS_OF_A_TORUS; i++) {
        double angle = 2 * M_PI * i / LIGHTS_OF_A_TORUS, position[3];
        vector_add_scaled(torus->center, torus->radius * cos(angle), u, position);
        vector_add_scaled(position, torus->radius * sin(angle), v, position);
        add(list, position, length / 2, torus->coefficient * length, torus->color);
    }
}

static void add_tori(light_list *list, const ew_sources_desc *sources)
{
    for (size_t i = 0; i < sources->torus_count; i++)
        add_torus(list, &sources->tori[i]);
}

/* The weight at `u` of the way along the curve: linear between the weights, which is close enough to their spline. */
static double weight_at(const ew_curve *curve, double u)
{
    if (curve->weight_count == 0) return 1;
    double at = u * (double)(curve->weight_count - 1);
    size_t i = (size_t)at;
    if (i + 1 >= curve->weight_count) return curve->weights[curve->weight_count - 1];
    return curve->weights[i] + (at - (double)i) * (curve->weights[i + 1] - curve->weights[i]);
}

static void curve_at(const ew_curve *curve, double t, double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = (curve->polynomial[2][i] * t + curve->polynomial[1][i]) * t + curve->polynomial[0][i];
}

static void add_curve(light_list *list, const ew_curve *curve)
{
    double domain = curve->domain[1] - curve->domain[0];
    for (int i = 0; i < LIGHTS_OF_A_CURVE; i++) {
        double start[3], middle[3], end[3], step[3];
        double t = curve->domain[0] + domain * (i + 0.5) / LIGHTS_OF_A_CURVE;
        curve_at(curve, t - domain * 0.5 / LIGHTS_OF_A_CURVE, start);
        curve_at(curve, t, middle);
        curve_at(curve, t + domain * 0.5 / LIGHTS_OF_A_CURVE, end);
        vector_subtract(end, start, step);
        double length = vector_length(step), weight = weight_at(curve, (i + 0.5) / LIGHTS_OF_A_CURVE);
        add(list, middle, length / 2, curve->coefficient * weight * length, curve->color);
    }
}

static void add_curves(light_list *list, const ew_sources_desc *sources)
{
    for (size_t i = 0; i < sources->curve_count; i++)
        add_curve(list, &sources->curves[i]);
}

/* One function for each kind of source that the court has. */
static void (*const add_kind[])(light_list *list, const ew_sources_desc *sources) = {add_points, add_tori, add_curves};

size_t energy_make_lights(const ew_sources_desc *sources, energy_light lights[ENERGY_MAX_LIGHTS])
{
    light_list list = {lights, 0};
    for (size_t i = 0; i < sizeof add_kind / sizeof *add_kind; i++)
        add_kind[i](&list, sources);
    return list.count;
}
