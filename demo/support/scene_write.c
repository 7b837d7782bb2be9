/* A scene as text: see scene_write.h. */
#include "scene_write.h"
#include "source_light.h"
#include "vector.h"

#include <jansson.h>

/* What jansson cannot allocate is NULL; adding that fails, and dumping an incomplete object is prevented by `ok`. */
typedef struct json_writer {
    bool ok;
} json_writer;

static void put(json_writer *w, json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value)) w->ok = false;
}

static void append(json_writer *w, json_t *array, json_t *value)
{
    if (json_array_append_new(array, value)) w->ok = false;
}

static json_t *numbers(json_writer *w, const double *values, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        append(w, array, json_real(values[i]));
    return array;
}

static json_t *positions(json_writer *w, const double (*values)[3], size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        append(w, array, numbers(w, values[i], 3));
    return array;
}

/* ---- Sources ------------------------------------------------------------------------------------------------------------ */

/* The members of every source. What is 0 stands for a default, but for a coefficient without a brightness. */
static void put_light(json_writer *w, json_t *object, source_light light)
{
    if (light.coefficient > 0 || light.reach == 0)
        put(w, object, "coefficient", json_real(light.coefficient));
    else
        put(w, object, "brightness", json_real(light.brightness));
    put(w, object, "color", numbers(w, light.color, 3));
    if (light.core > 0) put(w, object, "core", json_real(light.core));
    if (light.reach > 0) put(w, object, "reach", json_real(light.reach));
    if (light.sharpness > 0) put(w, object, "sharpness", json_real(light.sharpness));
}

static json_t *points_of(json_writer *w, const ew_sources_desc *sources)
{
    json_t *list = json_array();
    for (size_t i = 0; i < sources->point_count; i++) {
        json_t *object = json_object();
        put(w, object, "position", numbers(w, sources->points[i].position, 3));
        put_light(w, object, SOURCE_LIGHT(&sources->points[i]));
        append(w, list, object);
    }
    return list;
}

static json_t *lines_of(json_writer *w, const ew_sources_desc *sources)
{
    json_t *list = json_array();
    for (size_t i = 0; i < sources->line_count; i++) {
        json_t *object = json_object();
        put(w, object, "position", numbers(w, sources->lines[i].position, 3));
        put(w, object, "direction", numbers(w, sources->lines[i].direction, 3));
        put_light(w, object, SOURCE_LIGHT(&sources->lines[i]));
        append(w, list, object);
    }
    return list;
}

static json_t *tori_of(json_writer *w, const ew_sources_desc *sources)
{
    json_t *list = json_array();
    for (size_t i = 0; i < sources->torus_count; i++) {
        json_t *object = json_object();
        put(w, object, "center", numbers(w, sources->tori[i].center, 3));
        put(w, object, "axis", numbers(w, sources->tori[i].axis, 3));
        put(w, object, "radius", json_real(sources->tori[i].radius));
        put_light(w, object, SOURCE_LIGHT(&sources->tori[i]));
        append(w, list, object);
    }
    return list;
}

static json_t *curves_of(json_writer *w, const ew_sources_desc *sources)
{
    json_t *list = json_array();
    for (size_t i = 0; i < sources->curve_count; i++) {
        const ew_curve *curve = &sources->curves[i];
        json_t *object = json_object();
        put(w, object, "polynomial", positions(w, curve->polynomial, 3));
        put(w, object, "domain", numbers(w, curve->domain, 2));
        if (curve->weight_count > 0) put(w, object, "weights", numbers(w, curve->weights, curve->weight_count));
        put_light(w, object, SOURCE_LIGHT(curve));
        append(w, list, object);
    }
    return list;
}

static json_t *paths_of(json_writer *w, const ew_sources_desc *sources)
{
    static const char *const kinds[] = {[EW_PATH_POLYLINE] = "polyline",
                                        [EW_PATH_BSPLINE] = "bspline",
                                        [EW_PATH_BEZIER] = "bezier",
                                        [EW_PATH_CATMULL_ROM] = "catmull_rom"};
    json_t *list = json_array();
    for (size_t i = 0; i < sources->path_count; i++) {
        const ew_path *path = &sources->paths[i];
        json_t *object = json_object();
        put(w, object, "kind", json_string(kinds[path->kind]));
        put(w, object, "points", positions(w, path->points, path->point_count));
        if (path->is_closed) put(w, object, "closed", json_true());
        if (path->weight_count > 0) put(w, object, "weights", numbers(w, path->weights, path->weight_count));
        put_light(w, object, SOURCE_LIGHT(path));
        append(w, list, object);
    }
    return list;
}

static void put_sources(json_writer *w, json_t *root, const ew_sources_desc *sources)
{
    static const struct {
        const char *key;
        json_t *(*list_of)(json_writer *w, const ew_sources_desc *sources);
    } kinds[] = {{"points", points_of}, {"lines", lines_of}, {"tori", tori_of}, {"curves", curves_of}, {"paths", paths_of}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        json_t *list = kinds[i].list_of(w, sources);
        if (json_array_size(list) > 0)
            put(w, root, kinds[i].key, list);
        else
            json_decref(list);
    }
}

/* ---- The rest of the scene ---------------------------------------------------------------------------------------------- */

static json_t *opaque_of(json_writer *w, const opaque_shape *shape)
{
    static const char *const kinds[] = {[OPAQUE_BOX] = "box", [OPAQUE_PLANE] = "plane", [OPAQUE_SPHERE] = "sphere"};
    json_t *object = json_object();
    put(w, object, "shape", json_string(kinds[shape->kind]));
    switch (shape->kind) {
    case OPAQUE_BOX:
        put(w, object, "min", numbers(w, shape->shape.box.min, 3));
        put(w, object, "max", numbers(w, shape->shape.box.max, 3));
        break;
    case OPAQUE_PLANE:
        put(w, object, "point", numbers(w, shape->shape.plane.point, 3));
        put(w, object, "normal", numbers(w, shape->shape.plane.normal, 3));
        break;
    case OPAQUE_SPHERE:
        put(w, object, "center", numbers(w, shape->shape.sphere.center, 3));
        put(w, object, "radius", json_real(shape->shape.sphere.radius));
        break;
    }
    put(w, object, "color", numbers(w, shape->color, 3));
    return object;
}

static json_t *camera_of(json_writer *w, const scene_camera *camera)
{
    json_t *object = json_object();
    put(w, object, "eye", numbers(w, camera->eye, 3));
    put(w, object, "target", numbers(w, camera->target, 3));
    put(w, object, "up", numbers(w, camera->up, 3));
    if (camera->orthographic) {
        put(w, object, "projection", json_string("orthographic"));
        put(w, object, "height", json_real(camera->height));
    } else {
        put(w, object, "fov_y_degrees", json_real(camera->fov_y_degrees));
    }
    put(w, object, "near", json_real(camera->near_depth));
    put(w, object, "far", json_real(camera->far_depth));
    return object;
}

/* A pair of numbers with names, such as the interval. */
static json_t *pair_of(json_writer *w, const char *first_key, double first, const char *second_key, double second)
{
    json_t *object = json_object();
    put(w, object, first_key, json_real(first));
    put(w, object, second_key, json_real(second));
    return object;
}

static void put_light_on_surfaces(json_writer *w, json_t *root, const demo_scene *scene)
{
    if (scene->light_reach == 0) return;
    json_t *object = pair_of(w, "gain", scene->light_gain, "reach", scene->light_reach);
    if (scene->shadow_thickness > 0) put(w, object, "shadow_thickness", json_real(scene->shadow_thickness));
    put(w, root, "light", object);
}

static json_t *fog_of(json_writer *w, const ew_fog *fog)
{
    json_t *object = json_object();
    put(w, object, "extinction", json_real(fog->extinction));
    if (fog->scale == 0) return object;
    json_t *height = pair_of(w, "base", fog->base, "scale", fog->scale);
    put(w, height, "up", numbers(w, fog->up, 3));
    put(w, object, "height", height);
    return object;
}

/* Whether half axes are along those of the world, in their order. */
static bool is_upright(const ew_medium *medium)
{
    for (int i = 0; i < 9; i++)
        if (i % 4 != 0 && medium->half_axes[i / 3][i % 3] != 0) return false;
    return true;
}

static bool is_sphere(const ew_medium *medium)
{
    double radius = medium->half_axes[0][0];
    return is_upright(medium) && medium->half_axes[1][1] == radius && medium->half_axes[2][2] == radius;
}

/* A scene's boxes have the axes of the world: a file knows no others. */
static void put_body(json_writer *w, json_t *object, const ew_medium *medium)
{
    double radii[3], min[3], max[3];
    json_t *axes = json_array();
    for (int i = 0; i < 3; i++) {
        double unit[3];
        radii[i] = vector_length(medium->half_axes[i]);
        min[i] = medium->center[i] - radii[i];
        max[i] = medium->center[i] + radii[i];
        vector_normalize(medium->half_axes[i], unit);
        append(w, axes, numbers(w, unit, 3));
    }
    if (medium->shape == EW_MEDIUM_BOX) {
        put(w, object, "min", numbers(w, min, 3));
        put(w, object, "max", numbers(w, max, 3));
    } else {
        put(w, object, "center", numbers(w, medium->center, 3));
        if (is_sphere(medium))
            put(w, object, "radius", json_real(radii[0]));
        else
            put(w, object, "radii", numbers(w, radii, 3));
        if (!is_upright(medium)) put(w, object, "axes", json_incref(axes));
    }
    json_decref(axes);
}

static json_t *medium_of(json_writer *w, const ew_medium *medium)
{
    const char *shape = medium->shape == EW_MEDIUM_BOX ? "box" : is_sphere(medium) ? "sphere" : "ellipsoid";
    json_t *object = json_object();
    put(w, object, "shape", json_string(shape));
    put_body(w, object, medium);
    put(w, object, "extinction", json_real(medium->extinction));
    put(w, object, "albedo", json_real(medium->albedo));
    put(w, object, "ambient", numbers(w, medium->ambient, 3));
    return object;
}

static void put_look(json_writer *w, json_t *root, const demo_scene *scene)
{
    static const struct {
        ew_output composite;
        const char *name;
    } composites[] = {{EW_OUTPUT_LERP, "lerp"}, {EW_OUTPUT_ADD, "add"}, {EW_OUTPUT_SOFT, "soft"}};
    if (scene->sources.epsilon > 0) put(w, root, "epsilon", json_real(scene->sources.epsilon));
    if (scene->core_pixels >= 0) put(w, root, "core_pixels", json_real(scene->core_pixels));
    put(w, root, "exposure", json_real(scene->exposure));
    put_light_on_surfaces(w, root, scene);
    if (scene->fog.extinction > 0) put(w, root, "fog", fog_of(w, &scene->fog));
    put(w, root, "background", numbers(w, scene->background, 3));
    put(w, root, "color", numbers(w, scene->color, 3));
    for (size_t i = 0; i < sizeof composites / sizeof *composites; i++)
        if (composites[i].composite == scene->composite) put(w, root, "composite", json_string(composites[i].name));
}

char *scene_write(const demo_scene *scene)
{
    json_writer writer = {true}, *w = &writer;
    json_t *root = json_object(), *opaque = json_array(), *media = json_array();
    put(w, root, "version", json_integer(1));
    put(w, root, "camera", camera_of(w, &scene->camera));
    if (!scene_is_world(scene)) {
        put(w, root, "interval", pair_of(w, "start", scene->interval_start, "end", scene->interval_end));
        put(w, root, "decay", pair_of(w, "alpha", scene->decay_alpha, "beta", scene->decay_beta));
    }
    put_look(w, root, scene);
    put_sources(w, root, &scene->sources);
    for (size_t i = 0; i < scene->opaque_count; i++)
        append(w, opaque, opaque_of(w, &scene->opaque[i]));
    put(w, root, "opaque", opaque);
    for (size_t i = 0; i < scene->medium_count; i++)
        append(w, media, medium_of(w, &scene->media[i]));
    put(w, root, "media", media);
    char *text = w->ok ? json_dumps(root, JSON_INDENT(1) | JSON_REAL_PRECISION(17)) : NULL;
    json_decref(root);
    return text;
}
