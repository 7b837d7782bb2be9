/* A scene's pixels as rays: see scene_rays.h. */
#include "scene_rays.h"
#include "source_kinds.h"
#include "vector.h"

#include <math.h>

static void subtract_eye(const void *eye, double position[3])
{
    vector_subtract(position, eye, position);
}

bool scene_rays_create(const demo_scene *scene, int width, int height, scene_rays *rays)
{
    *rays = (scene_rays){
        .camera = scene->camera,
        .is_world = scene_is_world(scene),
        .interval_start = scene->interval_start,
        .interval_end = scene->interval_end,
        .decay_alpha = scene->decay_alpha,
        .decay_beta = scene->decay_beta,
        .core_pixels = scene->core_pixels,
        .fog = scene->fog,
        .width = width,
        .height = height,
    };
    const double *eye = scene->camera.eye;
    vector_subtract(scene->camera.target, eye, rays->forward);
    vector_normalize(rays->forward, rays->forward);
    vector_cross(rays->forward, scene->camera.up, rays->right);
    vector_normalize(rays->right, rays->right);
    vector_cross(rays->right, rays->forward, rays->up);

    if (!copy_source_lists(&scene->sources, &rays->sources)) return false;
    if (!opaque_make_mesh(scene, &rays->mesh)) {
        free_source_lists(&rays->sources);
        return false;
    }
    change_sources(&rays->sources, subtract_eye, NULL, eye);
    for (rays->medium_count = 0; rays->medium_count < scene->medium_count; rays->medium_count++) {
        ew_medium *medium = &rays->media[rays->medium_count];
        *medium = scene->media[rays->medium_count];
        vector_subtract(medium->center, eye, medium->center);
    }
    for (size_t i = 0; i < rays->mesh.vertex_count; i++)
        vector_subtract(rays->mesh.vertices[i].position, eye, rays->mesh.vertices[i].position);
    return true;
}

void scene_rays_free(scene_rays *rays)
{
    free_source_lists(&rays->sources);
    opaque_free_mesh(&rays->mesh);
}

/* Of the plane at view depth 1. */
static double half_height(const scene_rays *rays)
{
    return rays->camera.orthographic ? rays->camera.height / 2 : tan(rays->camera.fov_y_degrees * M_PI / 360);
}

/* The ray's points are origin + z direction, z being the view depth. */
static void view_ray(const scene_rays *rays, double x, double y, double origin[3], double direction[3])
{
    double u = (2 * x - rays->width) / rays->height * half_height(rays), v = (2 * y / rays->height - 1) * half_height(rays);
    for (int i = 0; i < 3; i++) {
        double across = u * rays->right[i] + v * rays->up[i];
        origin[i] = rays->camera.orthographic ? across : 0;
        direction[i] = rays->forward[i] + (rays->camera.orthographic ? 0 : across);
    }
}

/* Half of core_pixels pixels at a view depth. */
static double least_core_at(const scene_rays *rays, double view_depth)
{
    double pixel = 2 * half_height(rays) / rays->height * (rays->camera.orthographic ? 1 : view_depth);
    return 0.5 * rays->core_pixels * pixel;
}

/* The fog begins at the eye or, of an orthographic camera, at the near plane: at the view depth `first`. */
static reference_fog fog_of(const scene_rays *rays, const reference_ray *ray, double first, double start, double end)
{
    reference_fog fog = {.extinction = rays->fog.extinction, .begin = (first - start) / (end - start)};
    fog.has_height = rays->fog.scale > 0;
    if (!fog.has_height) return fog;
    double up[3];
    vector_normalize(rays->fog.up, up);
    double of_eye = vector_dot(up, rays->camera.eye);
    fog.height[0] = (of_eye + vector_dot(up, ray->start) - rays->fog.base) / rays->fog.scale;
    fog.height[1] = (of_eye + vector_dot(up, ray->end) - rays->fog.base) / rays->fog.scale;
    return fog;
}

/* The part of a ray, start + s step, that is in a body: as what is left of the whole line by the slabs of a box, or by the ball
 * that an ellipsoid is in its own space. Cramer's rule brings places there. */
static bool meets_body(const ew_medium *medium, const double start[3], const double step[3], double *from, double *to)
{
    double place[3], along[3], from_center[3], square = 0, product = 0, rest = -1;
    vector_subtract(start, medium->center, from_center);
    *from = -HUGE_VAL;
    *to = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double across[3];
        vector_cross(medium->half_axes[(i + 1) % 3], medium->half_axes[(i + 2) % 3], across);
        double volume = vector_dot(medium->half_axes[i], across);
        place[i] = vector_dot(from_center, across) / volume;
        along[i] = vector_dot(step, across) / volume;
        square += along[i] * along[i];
        product += place[i] * along[i];
        rest += place[i] * place[i];
        if (medium->shape != EW_MEDIUM_BOX) continue;
        if (along[i] == 0 && fabs(place[i]) > 1) return false;
        if (along[i] == 0) continue;
        *from = fmax(*from, fmin((-1 - place[i]) / along[i], (1 - place[i]) / along[i]));
        *to = fmin(*to, fmax((-1 - place[i]) / along[i], (1 - place[i]) / along[i]));
    }
    double discriminant = product * product - square * rest;
    if (medium->shape == EW_MEDIUM_ELLIPSOID) {
        if (discriminant <= 0) return false;
        *from = (-product - sqrt(discriminant)) / square;
        *to = (-product + sqrt(discriminant)) / square;
    }
    return *from < *to;
}

static void find_bodies(const scene_rays *rays, reference_ray *ray)
{
    double step[3];
    reference_fog *fog = &ray->fog;
    vector_subtract(ray->end, ray->start, step);
    for (size_t i = 0; i < rays->medium_count; i++) {
        reference_body *body = &fog->bodies[fog->body_count];
        *body = (reference_body){.extinction = rays->media[i].extinction};
        if (meets_body(&rays->media[i], ray->start, step, &body->from, &body->to)) fog->body_count++;
    }
}

/* A ray of the world integral begins at the eye or, of an orthographic camera, at the near plane, and its s is the view depth
 * from there on. */
reference_ray scene_rays_ray(const scene_rays *rays, double x, double y, double opaque_depth)
{
    double origin[3], direction[3], start = rays->interval_start, end = rays->interval_end;
    view_ray(rays, x, y, origin, direction);
    if (rays->is_world) {
        start = rays->camera.orthographic ? rays->camera.near_depth : 0;
        end = start + 1;
    }
    double s_max = fmax(0, (opaque_depth - start) / (end - start));
    reference_ray ray = {
        .s_max = rays->is_world ? s_max : fmin(1, s_max),
        .is_world = rays->is_world,
        .decay_alpha = rays->decay_alpha,
        .decay_beta = rays->decay_beta,
        .least_core = {least_core_at(rays, start), least_core_at(rays, end)},
    };
    vector_add_scaled(origin, start, direction, ray.start);
    vector_add_scaled(origin, end, direction, ray.end);
    ray.fog = fog_of(rays, &ray, rays->camera.orthographic ? rays->camera.near_depth : 0, start, end);
    find_bodies(rays, &ray);
    return ray;
}

reference_ray scene_rays_pixel(const scene_rays *rays, int x, int y, double stored)
{
    bool is_endless = rays->is_world && stored >= 1;
    return scene_rays_ray(rays, x + 0.5, y + 0.5, is_endless ? HUGE_VAL : scene_rays_stored_depth(rays, stored));
}

void scene_rays_depth_range(const scene_rays *rays, double *middle, double *length)
{
    double to_target[3];
    *middle = 0.5 * (rays->interval_start + rays->interval_end);
    *length = rays->interval_end - rays->interval_start;
    if (!rays->is_world) return;
    vector_subtract(rays->camera.target, rays->camera.eye, to_target);
    *middle = *length = vector_length(to_target);
}

void scene_rays_project(const scene_rays *rays, const double place[3], double *x, double *y, double *view_depth)
{
    *view_depth = vector_dot(rays->forward, place);
    double scale = half_height(rays) * (rays->camera.orthographic ? 1 : *view_depth);
    *x = 0.5 * (rays->width + vector_dot(rays->right, place) / scale * rays->height);
    *y = 0.5 * rays->height * (1 + vector_dot(rays->up, place) / scale);
}

double scene_rays_stored_depth(const scene_rays *rays, double stored)
{
    double near_depth = rays->camera.near_depth, far_depth = rays->camera.far_depth;
    if (rays->camera.orthographic) return near_depth + stored * (far_depth - near_depth);
    return 1 / ((1 - stored) / near_depth + stored / far_depth);
}

float scene_rays_depth_to_store(const scene_rays *rays, double view_depth)
{
    double near_depth = rays->camera.near_depth, far_depth = rays->camera.far_depth;
    if (!(view_depth < far_depth)) return 1;
    double share = (view_depth - near_depth) / (far_depth - near_depth);
    return (float)(rays->camera.orthographic ? share : share * far_depth / view_depth);
}

double scene_rays_cast(const scene_rays *rays, double x, double y)
{
    double origin[3], direction[3], nearest = HUGE_VAL;
    view_ray(rays, x, y, origin, direction);
    for (size_t i = 0; i < rays->mesh.triangle_count; i++) {
        const unsigned *corners = rays->mesh.triangles[i];
        const double *a = rays->mesh.vertices[corners[0]].position;
        double ab[3], ac[3], from_a[3], p[3], q[3];
        vector_subtract(rays->mesh.vertices[corners[1]].position, a, ab);
        vector_subtract(rays->mesh.vertices[corners[2]].position, a, ac);
        vector_subtract(origin, a, from_a);
        vector_cross(direction, ac, p);
        vector_cross(from_a, ab, q);
        double determinant = vector_dot(ab, p);
        if (determinant == 0) continue;
        double u = vector_dot(from_a, p) / determinant, v = vector_dot(direction, q) / determinant;
        double depth = vector_dot(ac, q) / determinant;
        if (u >= 0 && v >= 0 && u + v <= 1 && depth >= rays->camera.near_depth && depth <= rays->camera.far_depth &&
            depth < nearest)
            nearest = depth;
    }
    return nearest;
}

void scene_rays_cast_all(const scene_rays *rays, float *depth)
{
    for (int y = 0; y < rays->height; y++)
        for (int x = 0; x < rays->width; x++)
            *depth++ = scene_rays_depth_to_store(rays, scene_rays_cast(rays, x + 0.5, y + 0.5));
}
