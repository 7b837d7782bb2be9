/* The camera in the user's hands: see camera_control.h. */
#include "camera_control.h"
#include "vector.h"

/* The largest latitude, in radians: closer to a pole, the camera would flip over. */
static const double steepest = 85 * M_PI / 180;

static void take_over(camera_control *control, const demo_scene *scene)
{
    if (!control->is_free) control->camera = scene->camera;
    control->is_free = true;
}

/* Unit vectors: right, up and forward as the camera sees them. */
static void axes_of(const scene_camera *camera, double right[3], double up[3], double forward[3])
{
    double towards[3];
    vector_subtract(camera->target, camera->eye, towards);
    vector_normalize(towards, forward);
    vector_cross(forward, camera->up, right);
    vector_normalize(right, right);
    vector_cross(right, forward, up);
}

static void rotate(const double axis[3], double angle, const double vector[3], double result[3])
{
    double across[3], along = vector_dot(axis, vector) * (1 - cos(angle));
    vector_cross(axis, vector, across);
    for (int i = 0; i < 3; i++)
        result[i] = cos(angle) * vector[i] + sin(angle) * across[i] + along * axis[i];
}

/* Turns `arm`, which lies along the view, about the camera's up vector, and then lifts it. */
static void turn(const scene_camera *camera, double arm[3], double right_degrees, double up_degrees)
{
    double upright[3], unit[3], right[3], turned[3];
    vector_normalize(camera->up, upright);
    rotate(upright, right_degrees * M_PI / 180, arm, turned);
    vector_normalize(turned, unit);
    double latitude = asin(fmin(fmax(vector_dot(unit, upright), -1), 1)), lift = up_degrees * M_PI / 180;
    lift = fmin(fmax(latitude + lift, fmin(-steepest, latitude)), fmax(steepest, latitude)) - latitude;
    vector_cross(turned, upright, right);
    vector_normalize(right, right);
    rotate(right, lift, turned, arm);
}

void camera_control_orbit(camera_control *control, const demo_scene *scene, double right, double up)
{
    take_over(control, scene);
    scene_camera *camera = &control->camera;
    double arm[3];
    vector_subtract(camera->eye, camera->target, arm);
    turn(camera, arm, right, up);
    vector_add_scaled(camera->target, 1, arm, camera->eye);
}

void camera_control_look(camera_control *control, const demo_scene *scene, double right, double up)
{
    take_over(control, scene);
    scene_camera *camera = &control->camera;
    double arm[3];
    vector_subtract(camera->target, camera->eye, arm);
    turn(camera, arm, -right, up);
    vector_add_scaled(camera->eye, 1, arm, camera->target);
}

void camera_control_fly(camera_control *control, const demo_scene *scene, const double distance[3])
{
    take_over(control, scene);
    scene_camera *camera = &control->camera;
    double axes[3][3];
    axes_of(camera, axes[0], axes[1], axes[2]);
    for (int i = 0; i < 3; i++) {
        vector_add_scaled(camera->eye, distance[i], axes[i], camera->eye);
        vector_add_scaled(camera->target, distance[i], axes[i], camera->target);
    }
}

void camera_control_approach(camera_control *control, const demo_scene *scene, double nearness)
{
    take_over(control, scene);
    scene_camera *camera = &control->camera;
    double arm[3];
    vector_subtract(camera->eye, camera->target, arm);
    vector_add_scaled(camera->target, 1 / nearness, arm, camera->eye);
    camera->height /= nearness;
}

static double distance_to_target(const scene_camera *camera)
{
    double arm[3];
    vector_subtract(camera->eye, camera->target, arm);
    return vector_length(arm);
}

demo_scene camera_control_scene(const camera_control *control, const demo_scene *scene, bool interval_follows)
{
    demo_scene seen = *scene;
    if (!control->is_free) return seen;
    seen.camera = control->camera;
    if (!interval_follows || scene_is_world(scene)) return seen;
    double step = distance_to_target(&control->camera) - distance_to_target(&scene->camera);
    double nearest = seen.camera.orthographic ? scene->interval_start + step : fmax(seen.camera.near_depth, 1e-3);
    seen.interval_start = fmax(scene->interval_start + step, nearest);
    seen.interval_end = fmax(scene->interval_end + step, seen.interval_start + 1e-3);
    return seen;
}
