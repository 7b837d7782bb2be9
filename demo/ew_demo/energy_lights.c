/* The energy as point lights: see energy_lights.h. */
#include "energy_lights.h"
#include "vector.h"

enum { LIGHTS_OF_A_TORUS = 12, LIGHTS_OF_A_PATH = 8 };

/* Light per metre of a source and unit of its coefficient. */
static const double gain = 1.6;

/* A point sheds as much light as so many radii of its core, seen as a line. */
static const double point_length = 6;

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
        light->color[i] = gain * intensity * color[i];
}

/* The coefficient that a brightness stands for: see energywave.h. */
static double coefficient_of(double brightness, double core, double reach)
{
    return brightness / (2 * log(reach / core));
}

static void add_points(light_list *list, const ew_sources_desc *sources)
{
    for (size_t i = 0; i < sources->point_count; i++) {
        const ew_point *point = &sources->points[i];
        double coefficient = coefficient_of(point->brightness, point->core, point->reach);
        add(list, point->position, 0.5, coefficient * point_length * point->core, point->color);
    }
}

static void add_torus(light_list *list, const ew_torus *torus)
{
    double axis[3], u[3], v[3], coefficient = coefficient_of(torus->brightness, torus->core, torus->reach);
    vector_normalize(torus->axis, axis);
    vector_across(axis, u, v);
    double length = 2 * M_PI * torus->radius / LIGHTS_OF_A_TORUS;
    for (int i = 0; i < LIGHTS_OF_A_TORUS; i++) {
        double angle = 2 * M_PI * i / LIGHTS_OF_A_TORUS, position[3];
        vector_add_scaled(torus->center, torus->radius * cos(angle), u, position);
        vector_add_scaled(position, torus->radius * sin(angle), v, position);
        add(list, position, length / 2, coefficient * length, torus->color);
    }
}

static void add_tori(light_list *list, const ew_sources_desc *sources)
{
    for (size_t i = 0; i < sources->torus_count; i++)
        add_torus(list, &sources->tori[i]);
}

/* The weight at `u` of the way along the path: linear between the weights, which is close enough to their spline. */
static double weight_at(const ew_path *path, double u)
{
    if (path->weight_count == 0) return 1;
    double at = u * (double)(path->weight_count - 1);
    size_t i = (size_t)at;
    if (i + 1 >= path->weight_count) return path->weights[path->weight_count - 1];
    return path->weights[i] + (at - (double)i) * (path->weights[i + 1] - path->weights[i]);
}

/* The place at `u` of the way along the path's points. Whatever its kind, the path itself is not far away. */
static void place_at(const ew_path *path, double u, double result[3])
{
    double at = u * (double)(path->point_count - 1), way[3];
    size_t i = (size_t)at < path->point_count - 1 ? (size_t)at : path->point_count - 2;
    vector_subtract(path->points[i + 1], path->points[i], way);
    vector_add_scaled(path->points[i], at - (double)i, way, result);
}

static void add_path(light_list *list, const ew_path *path)
{
    double coefficient = coefficient_of(path->brightness, path->core, path->reach);
    for (int i = 0; i < LIGHTS_OF_A_PATH; i++) {
        double u = (i + 0.5) / LIGHTS_OF_A_PATH, start[3], middle[3], end[3], step[3];
        place_at(path, (double)i / LIGHTS_OF_A_PATH, start);
        place_at(path, u, middle);
        place_at(path, (i + 1.0) / LIGHTS_OF_A_PATH, end);
        vector_subtract(end, start, step);
        double length = vector_length(step);
        add(list, middle, length / 2, coefficient * weight_at(path, u) * length, path->color);
    }
}

static void add_paths(light_list *list, const ew_sources_desc *sources)
{
    for (size_t i = 0; i < sources->path_count; i++)
        add_path(list, &sources->paths[i]);
}

/* One function for each kind of source that the court has. */
static void (*const add_kind[])(light_list *list, const ew_sources_desc *sources) = {add_points, add_tori, add_paths};

size_t energy_make_lights(const ew_sources_desc *sources, energy_light lights[ENERGY_MAX_LIGHTS])
{
    light_list list = {lights, 0};
    for (size_t i = 0; i < sizeof add_kind / sizeof *add_kind; i++)
        add_kind[i](&list, sources);
    return list.count;
}
