/* The opaque shapes and the media of a scene file: see scene_shapes.h. */
#include "scene_shapes.h"
#include "vector.h"

#include <math.h>

/* ---- Bodies ------------------------------------------------------------------------------------------------------------- */

static void read_block(json_reader *r, const json_value *value, double min[3], double max[3])
{
    reader_vector_member(r, value, "min", REQUIRED, ANY, min);
    reader_vector_member(r, value, "max", REQUIRED, ANY, max);
    json_place at = {&value->at, "max", 0};
    if (r->ok && !(min[0] < max[0] && min[1] < max[1] && min[2] < max[2]))
        reader_fail(r, &at, "must be larger than min in each of its 3 numbers");
}

static void read_ball(json_reader *r, const json_value *value, double center[3], double *radius)
{
    reader_vector_member(r, value, "center", REQUIRED, ANY, center);
    reader_number_member(r, value, "radius", REQUIRED, POSITIVE, radius);
}

/* ---- Opaque shapes ------------------------------------------------------------------------------------------------------ */

static void read_box(json_reader *r, const json_value *value, opaque_shape *result)
{
    static const char *const keys[] = {"shape", "name", "min", "max", "color", NULL};
    reader_check_keys(r, value, keys);
    read_block(r, value, result->shape.box.min, result->shape.box.max);
}

static void read_plane(json_reader *r, const json_value *value, opaque_shape *result)
{
    static const char *const keys[] = {"shape", "name", "point", "normal", "color", NULL};
    reader_check_keys(r, value, keys);
    reader_vector_member(r, value, "point", REQUIRED, ANY, result->shape.plane.point);
    reader_direction_member(r, value, "normal", result->shape.plane.normal);
}

static void read_sphere(json_reader *r, const json_value *value, opaque_shape *result)
{
    static const char *const keys[] = {"shape", "name", "center", "radius", "color", NULL};
    reader_check_keys(r, value, keys);
    read_ball(r, value, result->shape.sphere.center, &result->shape.sphere.radius);
}

static void read_opaque(json_reader *r, const json_value *value, void *result)
{
    static void (*const readers[])(json_reader *, const json_value *, opaque_shape *) = {
        [OPAQUE_BOX] = read_box, [OPAQUE_PLANE] = read_plane, [OPAQUE_SPHERE] = read_sphere};
    static const char *const kinds[] = {[OPAQUE_BOX] = "box", [OPAQUE_PLANE] = "plane", [OPAQUE_SPHERE] = "sphere", NULL};
    opaque_shape *shape = result;
    if (!reader_check_object(r, value)) return;
    shape->kind = (opaque_kind)reader_word_member(r, value, "shape", REQUIRED, kinds);
    if (!r->ok) return;
    readers[shape->kind](r, value, shape);
    reader_text_member(r, value, "name");
    for (int i = 0; i < 3; i++)
        shape->color[i] = 0.8;
    reader_vector_member(r, value, "color", OPTIONAL, NOT_NEGATIVE, shape->color);
}

void scene_read_opaque(json_reader *r, const json_value *root, demo_scene *scene)
{
    scene->opaque =
        reader_list_member(r, root, "opaque", MAX_OPAQUE_SHAPES, sizeof(opaque_shape), read_opaque, &scene->opaque_count);
}

/* ---- Media -------------------------------------------------------------------------------------------------------------- */

#define MEDIUM_KEYS "shape", "name", "extinction", "albedo", "ambient"

static void read_medium_box(json_reader *r, const json_value *value, ew_medium *medium)
{
    static const char *const keys[] = {MEDIUM_KEYS, "min", "max", NULL};
    double min[3], max[3];
    reader_check_keys(r, value, keys);
    read_block(r, value, min, max);
    for (int i = 0; i < 3 && r->ok; i++) {
        medium->center[i] = 0.5 * (min[i] + max[i]);
        medium->half_axes[i][i] = 0.5 * (max[i] - min[i]);
    }
}

static void read_medium_sphere(json_reader *r, const json_value *value, ew_medium *medium)
{
    static const char *const keys[] = {MEDIUM_KEYS, "center", "radius", NULL};
    double radius = 0;
    reader_check_keys(r, value, keys);
    read_ball(r, value, medium->center, &radius);
    for (int i = 0; i < 3; i++)
        medium->half_axes[i][i] = radius;
}

/* Without axes, the radii are along those of the world. */
static void read_ellipsoid(json_reader *r, const json_value *value, ew_medium *medium)
{
    static const char *const keys[] = {MEDIUM_KEYS, "center", "radii", "axes", NULL};
    double radii[3], axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, across[3];
    reader_check_keys(r, value, keys);
    reader_vector_member(r, value, "center", REQUIRED, ANY, medium->center);
    reader_vector_member(r, value, "radii", REQUIRED, POSITIVE, radii);
    if (reader_member(r, value, "axes", OPTIONAL).json) reader_matrix_member(r, value, "axes", axes);
    json_place at = {&value->at, "axes", 0};
    for (int i = 0; i < 3 && r->ok; i++) {
        if (vector_dot(axes[i], axes[i]) == 0) reader_fail(r, &at, "must be 3 directions, but one of them is zero");
        vector_normalize(axes[i], axes[i]);
        for (int k = 0; k < 3; k++)
            medium->half_axes[i][k] = radii[i] * axes[i][k];
    }
    vector_cross(axes[1], axes[2], across);
    if (r->ok && !(fabs(vector_dot(axes[0], across)) > 1e-6))
        reader_fail(r, &at, "must not lie in a plane; name 3 directions, best at right angles");
}

static void read_medium(json_reader *r, const json_value *value, void *result)
{
    static const struct {
        void (*read)(json_reader *, const json_value *, ew_medium *);
        ew_medium_shape shape;
    } readers[] = {
        {read_medium_box, EW_MEDIUM_BOX}, {read_medium_sphere, EW_MEDIUM_ELLIPSOID}, {read_ellipsoid, EW_MEDIUM_ELLIPSOID}};
    static const char *const shapes[] = {"box", "sphere", "ellipsoid", NULL};
    ew_medium *medium = result;
    *medium = (ew_medium){.ambient = {1, 1, 1}};
    if (!reader_check_object(r, value)) return;
    int shape = reader_word_member(r, value, "shape", REQUIRED, shapes);
    if (!r->ok) return;
    medium->shape = readers[shape].shape;
    readers[shape].read(r, value, medium);
    reader_text_member(r, value, "name");
    reader_factor_member(r, value, "extinction", REQUIRED, 1e12, &medium->extinction);
    reader_factor_member(r, value, "albedo", OPTIONAL, 1, &medium->albedo);
    reader_vector_member(r, value, "ambient", OPTIONAL, NOT_NEGATIVE, medium->ambient);
}

void scene_read_media(json_reader *r, const json_value *root, demo_scene *scene)
{
    scene->media = reader_list_member(r, root, "media", EW_MAX_MEDIA, sizeof(ew_medium), read_medium, &scene->medium_count);
}
