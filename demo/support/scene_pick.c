/* Picking: see scene_pick.h. */
#include "scene_pick.h"
#include "part_shape.h"
#include "vector.h"

/* Less light than this, where 1 is shown as white, is not what somebody clicks on. */
static const double least_light = 0.02;

/* ---- Opaque shapes: how far along the ray it meets them, in view depths -------------------------------------------------- */

static double meets_sphere(const camera_ray *ray, const double center[3], double radius)
{
    double way[3], squared = vector_dot(ray->direction, ray->direction);
    vector_subtract(center, ray->origin, way);
    double along = vector_dot(way, ray->direction) / squared;
    double half = along * along - (vector_dot(way, way) - radius * radius) / squared;
    return half > 0 && along - sqrt(half) > 0 ? along - sqrt(half) : HUGE_VAL;
}

static double meets_plane(const camera_ray *ray, const double point[3], const double normal[3])
{
    double way[3];
    vector_subtract(point, ray->origin, way);
    double depth = vector_dot(way, normal) / vector_dot(ray->direction, normal);
    return depth > 0 ? depth : HUGE_VAL;
}

static double meets_box(const camera_ray *ray, const double min[3], const double max[3])
{
    double first = 0, last = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double a = (min[i] - ray->origin[i]) / ray->direction[i], b = (max[i] - ray->origin[i]) / ray->direction[i];
        first = fmax(first, fmin(a, b));
        last = fmin(last, fmax(a, b));
    }
    return first > 0 && first < last ? first : HUGE_VAL;
}

/* Returns how far away the nearest one is, and sets `index` to which that is; infinity where there is none. */
static double nearest_wall(const demo_scene *scene, const camera_ray *ray, size_t *index)
{
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < scene->opaque_count; i++) {
        const opaque_shape *opaque = &scene->opaque[i];
        double depth = HUGE_VAL;
        switch (opaque->kind) {
        case OPAQUE_BOX:
            depth = meets_box(ray, opaque->shape.box.min, opaque->shape.box.max);
            break;
        case OPAQUE_PLANE:
            depth = meets_plane(ray, opaque->shape.plane.point, opaque->shape.plane.normal);
            break;
        case OPAQUE_SPHERE:
            depth = meets_sphere(ray, opaque->shape.sphere.center, opaque->shape.sphere.radius);
            break;
        }
        if (!(depth < nearest)) continue;
        nearest = depth;
        *index = i;
    }
    return nearest;
}

/* ---- Media --------------------------------------------------------------------------------------------------------------- */

/* The ray in the space in which the medium is the unit cube or the unit ball. */
static camera_ray ray_in_body(const camera_ray *ray, const ew_medium *medium)
{
    camera_ray result;
    double from[3], across[3];
    vector_subtract(ray->origin, medium->center, from);
    for (int i = 0; i < 3; i++) {
        vector_cross(medium->half_axes[(i + 1) % 3], medium->half_axes[(i + 2) % 3], across);
        double volume = vector_dot(medium->half_axes[i], across);
        result.origin[i] = vector_dot(from, across) / volume;
        result.direction[i] = vector_dot(ray->direction, across) / volume;
    }
    return result;
}

/* Like nearest_wall, of media that dim something. */
static double nearest_medium(const demo_scene *scene, const camera_ray *ray, size_t *index)
{
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < scene->medium_count; i++) {
        const ew_medium *medium = &scene->media[i];
        const camera_ray inside = ray_in_body(ray, medium);
        double depth = medium->shape == EW_MEDIUM_BOX ? meets_box(&inside, (double[]){-1, -1, -1}, (double[]){1, 1, 1})
                                                      : meets_sphere(&inside, (double[]){0, 0, 0}, 1);
        if (!(depth < nearest) || medium->extinction == 0) continue;
        nearest = depth;
        *index = i;
    }
    return nearest;
}

/* ---- Sources ------------------------------------------------------------------------------------------------------------- */

/* The search along one source. */
typedef struct pick_search {
    const camera_ray *ray;
    double wall; /* the view depth that ends it */
    double width;
    bool is_orthographic;
    double nearest; /* the least distance so far between the ray and the source */
} pick_search;

/* The place of a piece that is nearest to the ray, as a share of the way from a to b. */
static double share_of_piece(const camera_ray *ray, const double a[3], const double b[3])
{
    double way[3], from[3], unit[3];
    vector_normalize(ray->direction, unit);
    vector_subtract(b, a, way);
    vector_subtract(a, ray->origin, from);
    double along = vector_dot(way, unit), across = vector_dot(way, way) - along * along;
    if (!(across > 1e-12 * vector_dot(way, way))) return 0; /* a point, or a piece along the ray */
    return fmin(fmax((along * vector_dot(from, unit) - vector_dot(from, way)) / across, 0), 1);
}

static void search_piece(void *user, const double a[3], const double b[3])
{
    pick_search *search = user;
    const camera_ray *ray = search->ray;
    double way[3], place[3], apart[3];
    vector_subtract(b, a, way);
    vector_add_scaled(a, share_of_piece(ray, a, b), way, place);
    vector_subtract(place, ray->origin, apart);
    double depth = vector_dot(apart, ray->direction) / vector_dot(ray->direction, ray->direction);
    if (depth <= 0 || depth > search->wall) return;
    vector_add_scaled(apart, -depth, ray->direction, apart);
    double width = search->width * (search->is_orthographic ? 1 : depth);
    search->nearest = fmin(search->nearest, fmax(vector_length(apart) - width, 0));
}

/* The luminance of a long straight beam at that distance from the ray, with its sharpness. The papers' integral has sources
 * without a reach: here theirs is a thousand cores. */
static double light_at(source_light light, double epsilon, double distance)
{
    double core = light.core > 0 ? light.core : epsilon, reach = light.reach > 0 ? light.reach : 1e3 * core;
    double spread = log(reach / core), strongest = fmax(light.color[0], fmax(light.color[1], light.color[2]));
    double brightness = light.coefficient > 0 ? 2 * light.coefficient * spread : light.brightness;
    double share = log(reach / fmin(fmax(distance, core), reach)) / spread;
    return brightness * strongest * pow(share, light.sharpness > 0 ? light.sharpness : 1);
}

bool scene_pick(const demo_scene *scene, const camera_ray *ray, double width, scene_part *found)
{
    size_t wall_index = 0, medium_index = 0;
    double wall = nearest_wall(scene, ray, &wall_index), medium = nearest_medium(scene, ray, &medium_index), most = least_light;
    bool is_found = fmin(wall, medium) < scene->camera.far_depth;
    if (is_found) *found = wall <= medium ? (scene_part){PART_OPAQUE, wall_index} : (scene_part){PART_MEDIUM, medium_index};
    for (int kind = 0; part_is_source((part_kind)kind); kind++)
        for (size_t i = 0; i < scene_part_count(scene, (part_kind)kind); i++) {
            scene_part part = {(part_kind)kind, i};
            source_light light = scene_part_light(scene, part);
            /* The half of a core that stands out of a wall is seen. */
            pick_search search = {ray, wall + light.core, width, scene->camera.orthographic, HUGE_VAL};
            part_shape(scene, part, search_piece, &search);
            double shown = light_at(light, scene->sources.epsilon, search.nearest);
            if (!(shown > most)) continue;
            most = shown;
            *found = part;
            is_found = true;
        }
    return is_found;
}
