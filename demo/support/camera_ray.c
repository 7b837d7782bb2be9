/* A camera's rays: see camera_ray.h. */
#include "camera_ray.h"
#include "camera.h"
#include "vector.h"

double camera_half_height(const scene_camera *camera, double depth)
{
    return camera->orthographic ? camera->height / 2 : depth * tan(camera->fov_y_degrees * M_PI / 360);
}

camera_ray camera_ray_at(const scene_camera *camera, double aspect, const double place[2])
{
    double axes[3][3], offset[3] = {0}, unit = camera_half_height(camera, 1);
    camera_axes(camera, axes);
    vector_add_scaled(offset, place[0] * aspect * unit, axes[0], offset);
    vector_add_scaled(offset, place[1] * unit, axes[1], offset);
    camera_ray ray = {.direction = {-axes[2][0], -axes[2][1], -axes[2][2]}};
    vector_copy(camera->eye, ray.origin);
    double *start = camera->orthographic ? ray.origin : ray.direction;
    vector_add_scaled(start, 1, offset, start);
    return ray;
}

double camera_project(const scene_camera *camera, double aspect, const double position[3], double place[2])
{
    double seen[3];
    camera_to_view(camera, position, seen);
    double half = camera_half_height(camera, -seen[2]);
    place[0] = seen[0] / (half * aspect);
    place[1] = seen[1] / half;
    return -seen[2];
}

void camera_move_across(const scene_camera *camera, double aspect, const double place[2], double position[3])
{
    double seen[3];
    camera_to_view(camera, position, seen);
    camera_ray ray = camera_ray_at(camera, aspect, place);
    vector_add_scaled(ray.origin, -seen[2], ray.direction, position);
}
