/* The sources of a scene file: see scene_sources.h. */
#include "scene_sources.h"
#include "scene.h"
#include "vector.h"

/* ---- What all kinds have in common -------------------------------------------------------------------------------------- */

#define LIGHT_KEYS "name", "coefficient", "brightness", "color", "core", "reach", "sharpness"

/* The members with which a source of any kind ends. */
typedef struct source_light {
    double *coefficient;
    double *brightness;
    double *color;
    double *core;
    double *reach;
    double *sharpness;
} source_light;

#define LIGHT_OF(source)                                                                                                       \
    (&(source_light){&(source)->coefficient, &(source)->brightness, (source)->color, &(source)->core, &(source)->reach,        \
                     &(source)->sharpness})

static bool has_member(const json_value *object, const char *key)
{
    return json_object_get(object->json, key) != NULL;
}

/* Checks a source that has no reach. */
static void check_without_reach(json_reader *r, const json_value *source, const demo_scene *scene)
{
    static const char *const dependent[] = {"brightness", "sharpness"};
    json_place reach = {&source->at, "reach", 0};
    if (scene_is_world(scene)) reader_fail(r, &reach, "is missing; add it, for a scene without an interval needs it");
    for (int i = 0; i < 2; i++) {
        json_place at = {&source->at, dependent[i], 0};
        if (has_member(source, dependent[i])) reader_fail(r, &at, "needs a reach; add one, or leave the %s out", dependent[i]);
    }
}

static void check_light(json_reader *r, const json_value *source, const source_light *light)
{
    const demo_scene *scene = r->context;
    json_place brightness = {&source->at, "brightness", 0}, reach = {&source->at, "reach", 0};
    json_place sharpness = {&source->at, "sharpness", 0};
    double core = has_member(source, "core") ? *light->core : scene->sources.epsilon;
    if (has_member(source, "brightness") && has_member(source, "coefficient"))
        reader_fail(r, &brightness, "must not stand beside a coefficient; leave one of the two out");
    if (!has_member(source, "reach"))
        check_without_reach(r, source, scene);
    else if (!(*light->reach > core))
        reader_fail(r, &reach, "must be more than the radius of the core, which is %g, but is %g", core, *light->reach);
    if (has_member(source, "sharpness") && !(*light->sharpness >= 1))
        reader_fail(r, &sharpness, "must be 1 or more, but is %g", *light->sharpness);
}

/* The reader's context is the scene, which has the defaults. */
static void read_light(json_reader *r, const json_value *source, const source_light *light)
{
    const demo_scene *scene = r->context;
    reader_text_member(r, source, "name");
    if (!has_member(source, "brightness")) *light->coefficient = 1;
    reader_number_member(r, source, "coefficient", OPTIONAL, NOT_NEGATIVE, light->coefficient);
    reader_number_member(r, source, "brightness", OPTIONAL, NOT_NEGATIVE, light->brightness);
    vector_copy(scene->color, light->color);
    reader_vector_member(r, source, "color", OPTIONAL, NOT_NEGATIVE, light->color);
    reader_number_member(r, source, "core", OPTIONAL, POSITIVE, light->core);
    reader_number_member(r, source, "reach", OPTIONAL, POSITIVE, light->reach);
    reader_number_member(r, source, "sharpness", OPTIONAL, ANY, light->sharpness);
    if (r->ok) check_light(r, source, light);
}

static void read_weight(json_reader *r, const json_value *weight, void *result)
{
    reader_number(r, weight, NOT_NEGATIVE, result);
}

/* Of a curve or a path. */
static const double *read_weights(json_reader *r, const json_value *source, size_t *count)
{
    json_value weights = reader_member(r, source, "weights", OPTIONAL);
    const double *result = reader_list_member(r, source, "weights", EW_MAX_WEIGHTS, sizeof(double), read_weight, count);
    if (weights.json && !result) reader_fail(r, &weights.at, "must not be empty; leave it out for an even brightness");
    return result;
}

/* ---- The kinds ---------------------------------------------------------------------------------------------------------- */

static void read_point(json_reader *r, const json_value *source, void *result)
{
    static const char *const keys[] = {"position", LIGHT_KEYS, NULL};
    ew_point *point = result;
    reader_check_keys(r, source, keys);
    reader_vector_member(r, source, "position", REQUIRED, ANY, point->position);
    read_light(r, source, LIGHT_OF(point));
}

static void read_points(json_reader *r, const json_value *root, ew_sources_desc *sources)
{
    sources->points = reader_list_member(r, root, "points", EW_MAX_POINTS, sizeof(ew_point), read_point, &sources->point_count);
}

static void read_line(json_reader *r, const json_value *source, void *result)
{
    static const char *const keys[] = {"position", "direction", LIGHT_KEYS, NULL};
    ew_line *line = result;
    reader_check_keys(r, source, keys);
    reader_vector_member(r, source, "position", REQUIRED, ANY, line->position);
    reader_direction_member(r, source, "direction", line->direction);
    read_light(r, source, LIGHT_OF(line));
}

static void read_lines(json_reader *r, const json_value *root, ew_sources_desc *sources)
{
    sources->lines = reader_list_member(r, root, "lines", EW_MAX_LINES, sizeof(ew_line), read_line, &sources->line_count);
}

static void read_torus(json_reader *r, const json_value *source, void *result)
{
    static const char *const keys[] = {"center", "axis", "radius", LIGHT_KEYS, NULL};
    ew_torus *torus = result;
    reader_check_keys(r, source, keys);
    reader_vector_member(r, source, "center", REQUIRED, ANY, torus->center);
    reader_direction_member(r, source, "axis", torus->axis);
    reader_number_member(r, source, "radius", REQUIRED, NOT_NEGATIVE, &torus->radius);
    read_light(r, source, LIGHT_OF(torus));
}

static void read_tori(json_reader *r, const json_value *root, ew_sources_desc *sources)
{
    sources->tori = reader_list_member(r, root, "tori", EW_MAX_TORI, sizeof(ew_torus), read_torus, &sources->torus_count);
}

static void read_domain(json_reader *r, const json_value *source, double domain[2])
{
    domain[0] = 0;
    domain[1] = 1;
    json_value interval = reader_member(r, source, "domain", OPTIONAL);
    if (!interval.json) return;
    if (!json_is_array(interval.json) || json_array_size(interval.json) != 2) {
        reader_fail(r, &interval.at, "must be an array of 2 numbers");
        return;
    }
    for (size_t i = 0; i < 2; i++) {
        json_value end = reader_element(&interval, i);
        reader_number(r, &end, ANY, &domain[i]);
    }
    if (r->ok && !(domain[0] < domain[1])) reader_fail(r, &interval.at, "must grow from its first number to its second");
}

static void read_curve(json_reader *r, const json_value *source, void *result)
{
    static const char *const keys[] = {"control_points", "polynomial", "domain", "weights", LIGHT_KEYS, NULL};
    ew_curve *curve = result;
    reader_check_keys(r, source, keys);
    bool bezier = has_member(source, "control_points"), polynomial = has_member(source, "polynomial");
    if (bezier == polynomial) reader_fail(r, &source->at, "must have either control_points or a polynomial");
    if (bezier) {
        double control_points[3][3] = {{0}};
        reader_matrix_member(r, source, "control_points", control_points);
        ew_bezier_polynomial(control_points[0], control_points[1], control_points[2], curve->polynomial);
    } else if (polynomial) {
        reader_matrix_member(r, source, "polynomial", curve->polynomial);
    }
    read_domain(r, source, curve->domain);
    curve->weights = read_weights(r, source, &curve->weight_count);
    read_light(r, source, LIGHT_OF(curve));
}

static void read_curves(json_reader *r, const json_value *root, ew_sources_desc *sources)
{
    sources->curves = reader_list_member(r, root, "curves", EW_MAX_CURVES, sizeof(ew_curve), read_curve, &sources->curve_count);
}

/* Bounds for the reader: a path takes 5 units of an effect's EW_MAX_SOURCE_UNITS or more, and the library counts its pieces. */
enum { MAX_PATHS = EW_MAX_SOURCE_UNITS / 6, MAX_PATH_POINTS = 4096 };

static void read_path_point(json_reader *r, const json_value *point, void *result)
{
    reader_vector(r, point, ANY, result);
}

static void check_path_points(json_reader *r, const json_value *source, const ew_path *path)
{
    json_place points = {&source->at, "points", 0}, closed = {&source->at, "closed", 0};
    size_t count = path->point_count, least = path->is_closed || path->kind == EW_PATH_BSPLINE ? 3 : 2;
    if (path->kind == EW_PATH_BEZIER && path->is_closed)
        reader_fail(r, &closed, "must be false for a bezier; let it end at its first point instead");
    else if (path->kind == EW_PATH_BEZIER && (count < 4 || count % 3 != 1))
        reader_fail(r, &points, "must be 3 n + 1 points for a bezier, such as 4 or 7, but are %zu", count);
    else if (count < least)
        reader_fail(r, &points, "must be %zu points or more for this path, but are %zu", least, count);
}

static void read_path(json_reader *r, const json_value *source, void *result)
{
    static const char *const keys[] = {"kind", "points", "closed", "weights", LIGHT_KEYS, NULL};
    static const char *const kinds[] = {[EW_PATH_POLYLINE] = "polyline",
                                        [EW_PATH_BSPLINE] = "bspline",
                                        [EW_PATH_BEZIER] = "bezier",
                                        [EW_PATH_CATMULL_ROM] = "catmull_rom",
                                        NULL};
    ew_path *path = result;
    reader_check_keys(r, source, keys);
    path->kind = (ew_path_kind)reader_word_member(r, source, "kind", OPTIONAL, kinds);
    path->is_closed = reader_bool_member(r, source, "closed");
    reader_member(r, source, "points", REQUIRED);
    path->points =
        reader_list_member(r, source, "points", MAX_PATH_POINTS, sizeof(double[3]), read_path_point, &path->point_count);
    if (r->ok) check_path_points(r, source, path);
    path->weights = read_weights(r, source, &path->weight_count);
    read_light(r, source, LIGHT_OF(path));
}

static void read_paths(json_reader *r, const json_value *root, ew_sources_desc *sources)
{
    sources->paths = reader_list_member(r, root, "paths", MAX_PATHS, sizeof(ew_path), read_path, &sources->path_count);
}

const scene_source_kind scene_source_kinds[SCENE_SOURCE_KIND_COUNT] = {
    {"points", read_points}, {"lines", read_lines}, {"tori", read_tori}, {"curves", read_curves}, {"paths", read_paths},
};
