/* The shapes of parts: see part_shape.h. */
#include "part_shape.h"
#include "vector.h"

#include <stdbool.h>
#include <string.h>

enum { PIECES_OF_BEND = 16, PIECES_OF_CIRCLE = 64, PIECES_OF_HALF_LINE = 40 };

/* Who takes the pieces. */
typedef struct shape_taker {
    part_piece *take;
    void *user;
} shape_taker;

static void mix(const double a[3], const double b[3], double share, double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] + share * (b[i] - a[i]);
}

/* Pieces grow with the distance from the line's position, because the position is where one is likely to look. */
static void line_shape(const shape_taker *taker, const ew_line *line)
{
    const double growth = 1.17;
    double direction[3];
    vector_normalize(line->direction, direction);
    for (int side = -1; side <= 1; side += 2) {
        double a[3], b[3];
        vector_copy(line->position, a);
        for (int i = 1; i <= PIECES_OF_HALF_LINE; i++) {
            vector_add_scaled(line->position, side * (pow(growth, i) - 1), direction, b);
            taker->take(taker->user, a, b);
            vector_copy(b, a);
        }
    }
}

/* A polygon of so many corners in the ellipse with the conjugate half axes u and v. */
static void ellipse_shape(const shape_taker *taker, const double center[3], const double u[3], const double v[3], int count)
{
    double a[3], b[3];
    vector_add_scaled(center, 1, u, a);
    for (int i = 1; i <= count; i++) {
        double angle = 2 * M_PI * i / count;
        vector_add_scaled(center, cos(angle), u, b);
        vector_add_scaled(b, sin(angle), v, b);
        taker->take(taker->user, a, b);
        vector_copy(b, a);
    }
}

static void circle_shape(const shape_taker *taker, const double center[3], const double direction[3], double radius, int count)
{
    double axis[3], u[3], v[3];
    vector_normalize(direction, axis);
    vector_across(axis, u, v);
    for (int i = 0; i < 3; i++) {
        u[i] *= radius;
        v[i] *= radius;
    }
    ellipse_shape(taker, center, u, v, count);
}

static void curve_shape(const shape_taker *taker, const ew_curve *curve)
{
    double a[3], b[3];
    for (int i = 0; i <= 2 * PIECES_OF_BEND; i++) {
        double t = curve->domain[0] + (curve->domain[1] - curve->domain[0]) * i / (2 * PIECES_OF_BEND);
        vector_add_scaled(curve->polynomial[0], t, curve->polynomial[1], b);
        vector_add_scaled(b, t * t, curve->polynomial[2], b);
        if (i > 0) taker->take(taker->user, a, b);
        vector_copy(b, a);
    }
}

/* De Casteljau's construction: the place at `share` of the Bezier curve of 3 or 4 points. */
static void bezier_at(const double (*points)[3], int count, double share, double result[3])
{
    double mixed[4][3];
    memcpy(mixed, points, (size_t)count * sizeof *mixed);
    for (int left = count - 1; left > 0; left--)
        for (int i = 0; i < left; i++)
            mix(mixed[i], mixed[i + 1], share, mixed[i]);
    vector_copy(mixed[0], result);
}

static void bezier_shape(const shape_taker *taker, const double (*points)[3], int count)
{
    double a[3], b[3];
    vector_copy(points[0], a);
    for (int i = 1; i <= PIECES_OF_BEND; i++) {
        bezier_at(points, count, (double)i / PIECES_OF_BEND, b);
        taker->take(taker->user, a, b);
        vector_copy(b, a);
    }
}

/* The path's point of this number, from 1 on. Beyond the ends of an open path, at 0 and at one more than there are, it is the
 * mirror image of the last but one. */
static void path_point(const ew_path *path, size_t number, double result[3])
{
    const double(*points)[3] = path->points;
    size_t n = path->point_count;
    if (path->is_closed)
        vector_copy(points[(number + n - 1) % n], result);
    else if (number == 0)
        mix(points[1], points[0], 2, result);
    else if (number > n)
        mix(points[n - 2], points[n - 1], 2, result);
    else
        vector_copy(points[number - 1], result);
}

/* Each piece of a B-spline belongs to one point; it runs from half way to the last one to half way to the next. */
static void bspline_shape(const shape_taker *taker, const ew_path *path)
{
    size_t n = path->point_count;
    bool is_open = !path->is_closed;
    for (size_t i = is_open; i < n - is_open; i++) {
        double before[3], after[3], bezier[3][3];
        path_point(path, i, before);
        path_point(path, i + 1, bezier[1]);
        path_point(path, i + 2, after);
        mix(before, bezier[1], is_open && i == 1 ? 0 : 0.5, bezier[0]);
        mix(bezier[1], after, is_open && i == n - 2 ? 1 : 0.5, bezier[2]);
        bezier_shape(taker, (const double(*)[3])bezier, 3);
    }
}

static void catmull_rom_shape(const shape_taker *taker, const ew_path *path)
{
    for (size_t i = 0; i + !path->is_closed < path->point_count; i++) {
        double near_points[4][3], bezier[4][3];
        for (size_t k = 0; k < 4; k++)
            path_point(path, i + k, near_points[k]);
        for (int axis = 0; axis < 3; axis++) {
            bezier[0][axis] = near_points[1][axis];
            bezier[1][axis] = near_points[1][axis] + (near_points[2][axis] - near_points[0][axis]) / 6;
            bezier[2][axis] = near_points[2][axis] - (near_points[3][axis] - near_points[1][axis]) / 6;
            bezier[3][axis] = near_points[2][axis];
        }
        bezier_shape(taker, (const double(*)[3])bezier, 4);
    }
}

static void path_shape(const shape_taker *taker, const ew_path *path)
{
    switch (path->kind) {
    case EW_PATH_POLYLINE:
        for (size_t i = 0; i + !path->is_closed < path->point_count; i++)
            taker->take(taker->user, path->points[i], path->points[(i + 1) % path->point_count]);
        break;
    case EW_PATH_BSPLINE:
        bspline_shape(taker, path);
        break;
    case EW_PATH_BEZIER:
        for (size_t i = 0; i + 3 < path->point_count; i += 3)
            bezier_shape(taker, path->points + i, 4);
        break;
    case EW_PATH_CATMULL_ROM:
        catmull_rom_shape(taker, path);
        break;
    }
}

/* ---- Opaque shapes and media --------------------------------------------------------------------------------------------- */

/* The corner with this number is at the positive ends of the half axes whose bits are set in it. */
static void box_corner(const double center[3], const double (*half_axes)[3], int number, double result[3])
{
    vector_copy(center, result);
    for (int axis = 0; axis < 3; axis++)
        vector_add_scaled(result, number >> axis & 1 ? 1 : -1, half_axes[axis], result);
}

static void box_shape(const shape_taker *taker, const double center[3], const double (*half_axes)[3])
{
    double a[3], b[3];
    for (int number = 0; number < 8; number++)
        for (int axis = 0; axis < 3; axis++) {
            if (number >> axis & 1) continue;
            box_corner(center, half_axes, number, a);
            box_corner(center, half_axes, number | 1 << axis, b);
            taker->take(taker->user, a, b);
        }
}

static void block_shape(const shape_taker *taker, const double min[3], const double max[3])
{
    double center[3], half_axes[3][3] = {{0}};
    mix(min, max, 0.5, center);
    for (int i = 0; i < 3; i++)
        half_axes[i][i] = 0.5 * (max[i] - min[i]);
    box_shape(taker, center, (const double(*)[3])half_axes);
}

static void sphere_shape(const shape_taker *taker, const double center[3], double radius)
{
    for (int axis = 0; axis < 3; axis++)
        circle_shape(taker, center, (double[]){axis == 0, axis == 1, axis == 2}, radius, PIECES_OF_CIRCLE);
}

/* The square is a part of the distance at which the scene's own camera is, since a plane has no size. */
static void plane_shape(const shape_taker *taker, const scene_camera *camera, const double point[3], const double normal[3])
{
    double way[3];
    vector_subtract(camera->eye, point, way);
    circle_shape(taker, point, normal, 0.2 * vector_length(way), 4);
}

static void opaque_outline(const shape_taker *taker, const scene_camera *camera, const opaque_shape *opaque)
{
    switch (opaque->kind) {
    case OPAQUE_BOX:
        block_shape(taker, opaque->shape.box.min, opaque->shape.box.max);
        break;
    case OPAQUE_PLANE:
        plane_shape(taker, camera, opaque->shape.plane.point, opaque->shape.plane.normal);
        break;
    case OPAQUE_SPHERE:
        sphere_shape(taker, opaque->shape.sphere.center, opaque->shape.sphere.radius);
        break;
    }
}

/* A box's edges, or an ellipsoid's ellipses through each two of its axes. */
static void medium_outline(const shape_taker *taker, const ew_medium *medium)
{
    if (medium->shape == EW_MEDIUM_BOX) {
        box_shape(taker, medium->center, medium->half_axes);
        return;
    }
    for (int i = 0; i < 3; i++)
        ellipse_shape(taker, medium->center, medium->half_axes[i], medium->half_axes[(i + 1) % 3], PIECES_OF_CIRCLE);
}

void part_shape(const demo_scene *scene, scene_part part, part_piece *take, void *user)
{
    const ew_sources_desc *sources = &scene->sources;
    const shape_taker taker = {take, user};
    switch (part.kind) {
    case PART_POINT:
        take(user, sources->points[part.index].position, sources->points[part.index].position);
        break;
    case PART_LINE:
        line_shape(&taker, &sources->lines[part.index]);
        break;
    case PART_TORUS: {
        const ew_torus *torus = &sources->tori[part.index];
        circle_shape(&taker, torus->center, torus->axis, torus->radius, PIECES_OF_CIRCLE);
        break;
    }
    case PART_CURVE:
        curve_shape(&taker, &sources->curves[part.index]);
        break;
    case PART_PATH:
        path_shape(&taker, &sources->paths[part.index]);
        break;
    case PART_OPAQUE:
        opaque_outline(&taker, &scene->camera, &scene->opaque[part.index]);
        break;
    case PART_MEDIUM:
        medium_outline(&taker, &scene->media[part.index]);
        break;
    }
}
