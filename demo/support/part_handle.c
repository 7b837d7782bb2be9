/* Handles of parts: see part_handle.h. */
#include "part_handle.h"
#include "camera.h"
#include "camera_ray.h"
#include "scene_edit.h"
#include "vector.h"

#include <stdlib.h>

/* Of an arrow, relative to half of the picture's height at its depth. */
static const double arrow_length = 0.25;

/* ---- Handles of each sort -------------------------------------------------------------------------------------------------*/

static part_handle position_handle(const char *key, const double position[3])
{
    part_handle handle = {.kind = HANDLE_POSITION, .key = key};
    vector_copy(position, handle.position);
    return handle;
}

static part_handle element_handle(const char *key, size_t element, const double position[3])
{
    part_handle handle = {.kind = HANDLE_ELEMENT, .key = key, .element = element};
    vector_copy(position, handle.position);
    return handle;
}

static part_handle direction_handle(const char *key, const double from[3], const double direction[3],
                                    const scene_camera *camera)
{
    part_handle handle = {.kind = HANDLE_DIRECTION, .key = key};
    double unit[3], seen[3];
    vector_normalize(direction, unit);
    camera_to_view(camera, from, seen);
    vector_copy(from, handle.from);
    vector_add_scaled(from, arrow_length * camera_half_height(camera, fabs(seen[2])), unit, handle.position);
    return handle;
}

/* `out` is a unit vector. */
static part_handle radius_handle(const double from[3], double radius, const double out[3])
{
    part_handle handle = {.kind = HANDLE_RADIUS, .key = "radius"};
    vector_copy(from, handle.from);
    vector_add_scaled(from, radius, out, handle.position);
    return handle;
}

/* ---- Handles of each kind of part ---------------------------------------------------------------------------------------- */

static part_handle line_handle(const ew_line *line, const scene_camera *camera, size_t index)
{
    return index == 0 ? position_handle("position", line->position)
                      : direction_handle("direction", line->position, line->direction, camera);
}

/* The radius ends where the ring is furthest to the right or, if its axis points there, up. */
static part_handle torus_handle(const ew_torus *torus, const scene_camera *camera, size_t index)
{
    double axis[3], views[3][3], out[3];
    if (index == 0) return position_handle("center", torus->center);
    if (index == 1) return direction_handle("axis", torus->center, torus->axis, camera);
    vector_normalize(torus->axis, axis);
    camera_axes(camera, views);
    const double *side = fabs(vector_dot(axis, views[0])) < 0.9 ? views[0] : views[1];
    vector_add_scaled(side, -vector_dot(axis, side), axis, out);
    vector_normalize(out, out);
    return radius_handle(torus->center, torus->radius, out);
}

/* A curve that is given by its polynomial has one position, which moves all of it. */
static bool has_control_points(const char *text, scene_part part)
{
    return scene_edit_has(text, part, "control_points");
}

static part_handle curve_handle(const double (*polynomial)[3], bool is_bezier, size_t index)
{
    double position[3];
    if (!is_bezier) return element_handle("polynomial", 0, polynomial[0]);
    /* The control points are C0, C0 + C1 / 2, and C0 + C1 + C2. */
    vector_add_scaled(polynomial[0], 0.5 * (double)index, polynomial[1], position);
    if (index == 2) vector_add_scaled(position, 1, polynomial[2], position);
    return element_handle("control_points", index, position);
}

static part_handle box_handle(const double min[3], const double max[3], size_t index)
{
    part_handle handle = {.kind = HANDLE_BOX, .key = "min"};
    for (int i = 0; i < 3; i++)
        handle.position[i] = 0.5 * (min[i] + max[i]);
    if (index == 0) return handle;
    handle = position_handle(index == 1 ? "min" : "max", index == 1 ? min : max);
    handle.kind = index == 1 ? HANDLE_MIN : HANDLE_MAX;
    return handle;
}

static part_handle opaque_handle(const opaque_shape *opaque, const scene_camera *camera, size_t index)
{
    double axes[3][3];
    switch (opaque->kind) {
    case OPAQUE_BOX:
        break;
    case OPAQUE_PLANE:
        return index == 0 ? position_handle("point", opaque->shape.plane.point)
                          : direction_handle("normal", opaque->shape.plane.point, opaque->shape.plane.normal, camera);
    case OPAQUE_SPHERE:
        camera_axes(camera, axes);
        return index == 0 ? position_handle("center", opaque->shape.sphere.center)
                          : radius_handle(opaque->shape.sphere.center, opaque->shape.sphere.radius, axes[0]);
    }
    return box_handle(opaque->shape.box.min, opaque->shape.box.max, index);
}

/* Of a sphere or an ellipsoid: its middle, and the radius of the one or the radii of the other. */
static part_handle ellipsoid_handle(const ew_medium *medium, bool is_sphere, const scene_camera *camera, size_t index)
{
    double axes[3][3];
    if (index == 0) return position_handle("center", medium->center);
    camera_axes(camera, axes);
    if (is_sphere) return radius_handle(medium->center, vector_length(medium->half_axes[0]), axes[0]);
    part_handle handle = {.kind = HANDLE_RADII, .key = "radii", .element = index - 1};
    vector_copy(medium->center, handle.from);
    vector_add_scaled(medium->center, 1, medium->half_axes[index - 1], handle.position);
    return handle;
}

static bool is_sphere(const char *text, scene_part medium)
{
    return scene_edit_has(text, medium, "radius");
}

/* The corners of an opaque box or a medium's. */
static void box_corners(const demo_scene *scene, scene_part part, double min[3], double max[3])
{
    if (part.kind == PART_OPAQUE) {
        vector_copy(scene->opaque[part.index].shape.box.min, min);
        vector_copy(scene->opaque[part.index].shape.box.max, max);
        return;
    }
    const ew_medium *medium = &scene->media[part.index];
    for (int i = 0; i < 3; i++) {
        min[i] = medium->center[i] - medium->half_axes[i][i];
        max[i] = medium->center[i] + medium->half_axes[i][i];
    }
}

static part_handle medium_handle(const demo_scene *scene, const char *text, scene_part part, const scene_camera *camera,
                                 size_t index)
{
    const ew_medium *medium = &scene->media[part.index];
    double min[3], max[3];
    if (medium->shape == EW_MEDIUM_ELLIPSOID) return ellipsoid_handle(medium, is_sphere(text, part), camera, index);
    box_corners(scene, part, min, max);
    return box_handle(min, max, index);
}

size_t part_handle_count(const demo_scene *scene, const char *text, scene_part part)
{
    switch (part.kind) {
    case PART_POINT:
        return 1;
    case PART_LINE:
        return 2;
    case PART_TORUS:
        return 3;
    case PART_CURVE:
        return has_control_points(text, part) ? 3 : 1;
    case PART_PATH:
        return scene->sources.paths[part.index].point_count;
    case PART_OPAQUE:
        return scene->opaque[part.index].kind == OPAQUE_BOX ? 3 : 2;
    case PART_MEDIUM:
        break;
    }
    return scene->media[part.index].shape == EW_MEDIUM_BOX ? 3 : is_sphere(text, part) ? 2 : 4;
}

part_handle part_handle_at(const demo_scene *scene, const char *text, scene_part part, const scene_camera *camera, size_t index)
{
    const ew_sources_desc *sources = &scene->sources;
    switch (part.kind) {
    case PART_POINT:
        return position_handle("position", sources->points[part.index].position);
    case PART_LINE:
        return line_handle(&sources->lines[part.index], camera, index);
    case PART_TORUS:
        return torus_handle(&sources->tori[part.index], camera, index);
    case PART_CURVE:
        return curve_handle(sources->curves[part.index].polynomial, has_control_points(text, part), index);
    case PART_PATH:
        return element_handle("points", index, sources->paths[part.index].points[index]);
    case PART_OPAQUE:
        return opaque_handle(&scene->opaque[part.index], camera, index);
    case PART_MEDIUM:
        break;
    }
    return medium_handle(scene, text, part, camera, index);
}

/* ---- Moving -------------------------------------------------------------------------------------------------------------- */

/* Dividing by the inverse, a whole number where steps are small, gives the decimal's own double. */
static double round_to(double number, double step)
{
    return step < 1 ? round(number * round(1 / step)) / round(1 / step) : round(number / step) * step;
}

static void round_vector(const double vector[3], double step, double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = round_to(vector[i], step);
}

/* The direction of the arrow from its beginning to the place. */
static void arrow_to(const part_handle *handle, const double place[3], double step, double result[3])
{
    double arrow[3], way[3], unit[3];
    vector_subtract(handle->position, handle->from, arrow);
    vector_subtract(place, handle->from, way);
    vector_normalize(way, unit);
    round_vector(unit, pow(10, floor(log10(step / vector_length(arrow)))), result);
}

static char *move_box(const demo_scene *scene, const char *text, scene_part part, const part_handle *handle,
                      const double place[3], double step)
{
    double way[3], min[3], max[3];
    vector_subtract(place, handle->position, way);
    box_corners(scene, part, min, max);
    vector_add_scaled(min, 1, way, min);
    vector_add_scaled(max, 1, way, max);
    round_vector(min, step, min);
    round_vector(max, step, max);
    char *half = scene_edit_set_vector(text, part, "min", min);
    char *result = half ? scene_edit_set_vector(half, part, "max", max) : NULL;
    free(half);
    return result;
}

/* Each side of the box stays a step long at the least. */
static void corner_at(const demo_scene *scene, scene_part part, handle_kind kind, const double place[3], double step,
                      double result[3])
{
    double min[3], max[3];
    box_corners(scene, part, min, max);
    for (int i = 0; i < 3; i++)
        result[i] = kind == HANDLE_MIN ? fmin(place[i], max[i] - step) : fmax(place[i], min[i] + step);
    round_vector(result, step, result);
}

/* The ellipsoid's radii, one of them as long as its axis has to the place. */
static void radii_to(const ew_medium *medium, const part_handle *handle, const double place[3], double step, double result[3])
{
    double way[3], unit[3];
    for (int i = 0; i < 3; i++)
        result[i] = vector_length(medium->half_axes[i]);
    vector_normalize(medium->half_axes[handle->element], unit);
    vector_subtract(place, handle->from, way);
    result[handle->element] = fmax(round_to(fabs(vector_dot(way, unit)), step), step);
}

char *part_handle_move(const demo_scene *scene, const char *text, scene_part part, const part_handle *handle,
                       const double place[3], double step)
{
    double vector[3];
    switch (handle->kind) {
    case HANDLE_POSITION:
        break;
    case HANDLE_ELEMENT:
        round_vector(place, step, vector);
        return scene_edit_set_element(text, part, handle->key, handle->element, vector);
    case HANDLE_DIRECTION:
        arrow_to(handle, place, step, vector);
        return scene_edit_set_vector(text, part, handle->key, vector);
    case HANDLE_RADIUS:
        vector_subtract(place, handle->from, vector);
        return scene_edit_set_number(text, part, handle->key, fmax(round_to(vector_length(vector), step), step));
    case HANDLE_BOX:
        return move_box(scene, text, part, handle, place, step);
    case HANDLE_RADII:
        radii_to(&scene->media[part.index], handle, place, step, vector);
        return scene_edit_set_vector(text, part, handle->key, vector);
    case HANDLE_MIN:
    case HANDLE_MAX:
        corner_at(scene, part, handle->kind, place, step, vector);
        return scene_edit_set_vector(text, part, handle->key, vector);
    }
    round_vector(place, step, vector);
    return scene_edit_set_vector(text, part, handle->key, vector);
}
