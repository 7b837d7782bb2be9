/*
 * Reading and checking the scene file: see scene_file.h.
 *
 * The first fault met is the one reported; from then on the reading functions go on harmlessly, so that the code that reads
 * an object is simply the list of its members.
 */
#include "scene_file.h"
#include "message.h"
#include "vector.h"

#include <errno.h>
#include <jansson.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FILE_BYTES = 64 << 20 };
static const double largest_number = 1e18;

typedef struct reader {
    const char *name; /* the file, for messages */
    char *message;
    size_t size;
    bool ok; /* nothing wrong so far */
    const double *default_color;
} reader;

/* Where a value stands in the file: a member of its parent by key, or an element of it by index where the key is NULL. The
 * root has no parent. */
typedef struct place {
    const struct place *parent;
    const char *key;
    size_t index;
} place;

/* A JSON value and its place. A value that is absent has no JSON. */
typedef struct value {
    const json_t *json;
    place at;
} value;

typedef enum presence { REQUIRED, OPTIONAL } presence;
typedef enum range { ANY, NOT_NEGATIVE, POSITIVE } range;

/* ---- Messages ----------------------------------------------------------------------------------------------------------- */

/* Appends "curves[1].weights[3]" to `text`, whose end is at `length`; returns the new end. */
static size_t append_place(const place *at, char *text, size_t size, size_t length)
{
    if (!at->parent) return length;
    length = append_place(at->parent, text, size, length);
    if (length >= size) return length;
    int added = at->key ? snprintf(text + length, size - length, "%s%s", length ? "." : "", at->key)
                        : snprintf(text + length, size - length, "[%zu]", at->index);
    return length + (added > 0 ? (size_t)added : 0);
}

__attribute__((format(printf, 3, 4))) static void fail(reader *r, const place *at, const char *format, ...)
{
    if (!r->ok) return;
    r->ok = false;
    char where[160] = "", what[240];
    size_t length = append_place(at, where, sizeof where, 0);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    message_write(r->message, r->size, "%s: %s%s%s", r->name, where, length ? ": " : "", what);
}

static const char *type_text(const json_t *json)
{
    switch (json_typeof(json)) {
    case JSON_OBJECT:
        return "an object";
    case JSON_ARRAY:
        return "an array";
    case JSON_STRING:
        return "a string";
    case JSON_INTEGER:
    case JSON_REAL:
        return "a number";
    case JSON_NULL:
        return "null";
    default:
        return "true or false";
    }
}

/* ---- Values ------------------------------------------------------------------------------------------------------------- */

/* The object's member; absent, and a fault if it is required, where there is none. */
static value member(reader *r, const value *object, const char *key, presence needed)
{
    value result = {json_object_get(object->json, key), {&object->at, key, 0}};
    if (!result.json && needed == REQUIRED) fail(r, &result.at, "is missing; add it, for it has no default");
    return result;
}

static value element(const value *array, size_t index)
{
    return (value){json_array_get(array->json, index), {&array->at, NULL, index}};
}

static bool check_object(reader *r, const value *object)
{
    if (json_is_object(object->json)) return true;
    fail(r, &object->at, "must be an object, not %s", type_text(object->json));
    return false;
}

/* A fault unless the value is an object with no keys but the given ones, up to a NULL. */
static void check_keys(reader *r, const value *object, const char *const *keys)
{
    if (!check_object(r, object)) return;
    const char *key;
    const json_t *ignored;
    json_object_foreach((json_t *)object->json, key, ignored)
    {
        const char *const *known = keys;
        while (*known && strcmp(*known, key) != 0)
            known++;
        if (!*known) {
            place at = {&object->at, key, 0};
            char list[200] = "";
            for (known = keys; *known; known++) {
                size_t length = strlen(list);
                snprintf(list + length, sizeof list - length, "%s%s", known == keys ? "" : ", ", *known);
            }
            fail(r, &at, "is not a key of this place, which takes %s", list);
        }
    }
}

static bool check_array(reader *r, const value *array)
{
    if (json_is_array(array->json)) return true;
    fail(r, &array->at, "must be an array, not %s", type_text(array->json));
    return false;
}

static void read_number(reader *r, const value *number, range allowed, double *result)
{
    if (!json_is_number(number->json)) {
        fail(r, &number->at, "must be a number, not %s", type_text(number->json));
        return;
    }
    double x = json_number_value(number->json);
    if (!(fabs(x) <= largest_number))
        fail(r, &number->at, "must not be larger than %g, but is %g", largest_number, x);
    else if (allowed == NOT_NEGATIVE && x < 0)
        fail(r, &number->at, "must be 0 or more, but is %g", x);
    else if (allowed == POSITIVE && x <= 0)
        fail(r, &number->at, "must be more than 0, but is %g", x);
    else
        *result = x;
}

static void read_vector(reader *r, const value *vector, range allowed, double result[3])
{
    if (!json_is_array(vector->json) || json_array_size(vector->json) != 3) {
        fail(r, &vector->at, "must be an array of 3 numbers");
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        value number = element(vector, i);
        read_number(r, &number, allowed, &result[i]);
    }
}

/* The members of an object; those that are optional and absent leave `result` as it is. */

static void number_member(reader *r, const value *object, const char *key, presence needed, range allowed, double *result)
{
    value number = member(r, object, key, needed);
    if (number.json) read_number(r, &number, allowed, result);
}

static void vector_member(reader *r, const value *object, const char *key, presence needed, range allowed, double result[3])
{
    value vector = member(r, object, key, needed);
    if (vector.json) read_vector(r, &vector, allowed, result);
}

/* A required vector with a direction. */
static void direction_member(reader *r, const value *object, const char *key, double result[3])
{
    value vector = member(r, object, key, REQUIRED);
    double ignored[3];
    if (!vector.json) return;
    read_vector(r, &vector, ANY, result);
    if (r->ok && !vector_normalize(result, ignored)) fail(r, &vector.at, "must not be zero: it gives a direction");
}

static void matrix_member(reader *r, const value *object, const char *key, double result[3][3])
{
    value matrix = member(r, object, key, REQUIRED);
    if (!matrix.json) return;
    if (!json_is_array(matrix.json) || json_array_size(matrix.json) != 3) {
        fail(r, &matrix.at, "must be an array of 3 points");
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        value row = element(&matrix, i);
        read_vector(r, &row, ANY, result[i]);
    }
}

/* The index of the member's text among `words`, which end with a NULL; 0 where it is absent or wrong. */
static int word_member(reader *r, const value *object, const char *key, presence needed, const char *const *words)
{
    value word = member(r, object, key, needed);
    if (!word.json) return 0;
    if (json_is_string(word.json))
        for (int i = 0; words[i]; i++)
            if (strcmp(words[i], json_string_value(word.json)) == 0) return i;
    char list[100] = "";
    for (int i = 0; words[i]; i++) {
        size_t length = strlen(list);
        snprintf(list + length, sizeof list - length, "%s\"%s\"", i ? " or " : "", words[i]);
    }
    fail(r, &word.at, "must be %s", list);
    return 0;
}

/* Reads a list's elements of `element_size` bytes by `read`, which finds them zeroed; owned by the caller, faults or not. */
static void *list_member(reader *r, const value *object, const char *key, size_t limit, size_t element_size,
                         void (*read)(reader *, const value *, void *), size_t *count)
{
    *count = 0;
    value list = member(r, object, key, OPTIONAL);
    if (!list.json || !check_array(r, &list)) return NULL;
    size_t length = json_array_size(list.json);
    if (length == 0) return NULL;
    if (length > limit) {
        fail(r, &list.at, "must have %zu elements at most, but has %zu", limit, length);
        return NULL;
    }
    unsigned char *elements = calloc(length, element_size);
    if (!elements) {
        fail(r, &list.at, "does not fit into memory");
        return NULL;
    }
    *count = length;
    for (size_t i = 0; i < length && r->ok; i++) {
        value item = element(&list, i);
        read(r, &item, elements + i * element_size);
    }
    return elements;
}

/* ---- Sources ------------------------------------------------------------------------------------------------------------ */

static void read_light(reader *r, const value *source, double *coefficient, double color[3])
{
    *coefficient = 1;
    number_member(r, source, "coefficient", OPTIONAL, NOT_NEGATIVE, coefficient);
    vector_copy(r->default_color, color);
    vector_member(r, source, "color", OPTIONAL, NOT_NEGATIVE, color);
}

static void read_point(reader *r, const value *source, void *result)
{
    static const char *const keys[] = {"position", "coefficient", "color", NULL};
    ew_point *point = result;
    check_keys(r, source, keys);
    vector_member(r, source, "position", REQUIRED, ANY, point->position);
    read_light(r, source, &point->coefficient, point->color);
}

static void read_line(reader *r, const value *source, void *result)
{
    static const char *const keys[] = {"position", "direction", "coefficient", "color", NULL};
    ew_line *line = result;
    check_keys(r, source, keys);
    vector_member(r, source, "position", REQUIRED, ANY, line->position);
    direction_member(r, source, "direction", line->direction);
    read_light(r, source, &line->coefficient, line->color);
}

static void read_torus(reader *r, const value *source, void *result)
{
    static const char *const keys[] = {"center", "axis", "radius", "coefficient", "color", NULL};
    ew_torus *torus = result;
    check_keys(r, source, keys);
    vector_member(r, source, "center", REQUIRED, ANY, torus->center);
    direction_member(r, source, "axis", torus->axis);
    number_member(r, source, "radius", REQUIRED, NOT_NEGATIVE, &torus->radius);
    read_light(r, source, &torus->coefficient, torus->color);
}

static void read_weight(reader *r, const value *weight, void *result)
{
    read_number(r, weight, NOT_NEGATIVE, result);
}

static void read_domain(reader *r, const value *source, double domain[2])
{
    domain[0] = 0;
    domain[1] = 1;
    value interval = member(r, source, "domain", OPTIONAL);
    if (!interval.json) return;
    if (!json_is_array(interval.json) || json_array_size(interval.json) != 2) {
        fail(r, &interval.at, "must be an array of 2 numbers");
        return;
    }
    for (size_t i = 0; i < 2; i++) {
        value end = element(&interval, i);
        read_number(r, &end, ANY, &domain[i]);
    }
    if (r->ok && !(domain[0] < domain[1])) fail(r, &interval.at, "must grow from its first number to its second");
}

static void read_curve(reader *r, const value *source, void *result)
{
    static const char *const keys[] = {"control_points", "polynomial", "domain", "weights", "coefficient", "color", NULL};
    ew_curve *curve = result;
    check_keys(r, source, keys);
    bool bezier = json_object_get(source->json, "control_points"), polynomial = json_object_get(source->json, "polynomial");
    if (bezier == polynomial) fail(r, &source->at, "must have either control_points or a polynomial");
    if (bezier) {
        double control_points[3][3] = {{0}};
        matrix_member(r, source, "control_points", control_points);
        ew_bezier_polynomial(control_points, curve->polynomial);
    } else if (polynomial) {
        matrix_member(r, source, "polynomial", curve->polynomial);
    }
    read_domain(r, source, curve->domain);
    curve->weights = list_member(r, source, "weights", EW_MAX_WEIGHTS, sizeof(double), read_weight, &curve->weight_count);
    value weights = member(r, source, "weights", OPTIONAL);
    if (weights.json && !curve->weights) fail(r, &weights.at, "must not be empty; leave it out for an even brightness");
    read_light(r, source, &curve->coefficient, curve->color);
}

/* ---- Opaque shapes ------------------------------------------------------------------------------------------------------ */

static void read_opaque(reader *r, const value *shape, void *result)
{
    static const char *const keys[][5] = {
        [OPAQUE_BOX] = {"shape", "min", "max", "color"},
        [OPAQUE_PLANE] = {"shape", "point", "normal", "color"},
        [OPAQUE_SPHERE] = {"shape", "center", "radius", "color"},
    };
    static const char *const kinds[] = {[OPAQUE_BOX] = "box", [OPAQUE_PLANE] = "plane", [OPAQUE_SPHERE] = "sphere", NULL};
    opaque_shape *opaque = result;
    if (!check_object(r, shape)) return;
    opaque->kind = (opaque_kind)word_member(r, shape, "shape", REQUIRED, kinds);
    if (!r->ok) return;
    check_keys(r, shape, keys[opaque->kind]);
    switch (opaque->kind) {
    case OPAQUE_BOX: {
        double *min = opaque->shape.box.min, *max = opaque->shape.box.max;
        vector_member(r, shape, "min", REQUIRED, ANY, min);
        vector_member(r, shape, "max", REQUIRED, ANY, max);
        if (r->ok && !(min[0] < max[0] && min[1] < max[1] && min[2] < max[2])) {
            place at = {&shape->at, "max", 0};
            fail(r, &at, "must be larger than min in each of its 3 numbers");
        }
        break;
    }
    case OPAQUE_PLANE:
        vector_member(r, shape, "point", REQUIRED, ANY, opaque->shape.plane.point);
        direction_member(r, shape, "normal", opaque->shape.plane.normal);
        break;
    case OPAQUE_SPHERE:
        vector_member(r, shape, "center", REQUIRED, ANY, opaque->shape.sphere.center);
        number_member(r, shape, "radius", REQUIRED, POSITIVE, &opaque->shape.sphere.radius);
        break;
    }
    for (int i = 0; i < 3; i++)
        opaque->color[i] = 0.8;
    vector_member(r, shape, "color", OPTIONAL, NOT_NEGATIVE, opaque->color);
}

/* ---- The rest of the scene ---------------------------------------------------------------------------------------------- */

static void read_camera(reader *r, const value *root, scene_camera *camera)
{
    static const char *const perspective_keys[] = {"projection", "eye", "target", "up", "fov_y_degrees", "near", "far", NULL};
    static const char *const orthographic_keys[] = {"projection", "eye", "target", "up", "height", "near", "far", NULL};
    static const char *const projections[] = {"perspective", "orthographic", NULL};
    *camera = (scene_camera){.up = {0, 1, 0}, .fov_y_degrees = 45, .height = 2, .near_depth = 0.1, .far_depth = 100};
    value object = member(r, root, "camera", REQUIRED);
    if (!object.json || !check_object(r, &object)) return;
    camera->orthographic = word_member(r, &object, "projection", OPTIONAL, projections) == 1;
    check_keys(r, &object, camera->orthographic ? orthographic_keys : perspective_keys);
    vector_member(r, &object, "eye", REQUIRED, ANY, camera->eye);
    vector_member(r, &object, "target", REQUIRED, ANY, camera->target);
    vector_member(r, &object, "up", OPTIONAL, ANY, camera->up);
    number_member(r, &object, "fov_y_degrees", OPTIONAL, POSITIVE, &camera->fov_y_degrees);
    number_member(r, &object, "height", OPTIONAL, POSITIVE, &camera->height);
    number_member(r, &object, "near", OPTIONAL, camera->orthographic ? ANY : POSITIVE, &camera->near_depth);
    number_member(r, &object, "far", OPTIONAL, ANY, &camera->far_depth);
    if (!r->ok) return;

    double direction[3], up[3], right[3];
    place target_place = {&object.at, "target", 0}, up_place = {&object.at, "up", 0};
    place fov_place = {&object.at, "fov_y_degrees", 0}, far_place = {&object.at, "far", 0};
    vector_subtract(camera->target, camera->eye, direction);
    if (!vector_normalize(direction, direction)) {
        fail(r, &target_place, "must not be where the camera's eye is");
        return;
    }
    if (!vector_normalize(camera->up, up)) {
        fail(r, &up_place, "must not be zero: it gives a direction");
        return;
    }
    vector_cross(direction, up, right);
    if (vector_length(right) < 1e-6) fail(r, &up_place, "must not point along the view, from eye to target");
    if (camera->fov_y_degrees < 1e-3 || camera->fov_y_degrees > 179)
        fail(r, &fov_place, "must be from 0.001 to 179, but is %g", camera->fov_y_degrees);
    if (!(camera->far_depth > camera->near_depth))
        fail(r, &far_place, "must be more than near, which is %g, but is %g", camera->near_depth, camera->far_depth);
}

static void read_interval(reader *r, const value *root, demo_scene *scene)
{
    static const char *const keys[] = {"start", "end", NULL};
    scene->interval_start = scene->camera.near_depth;
    scene->interval_end = scene->camera.far_depth;
    value object = member(r, root, "interval", OPTIONAL);
    if (!object.json) return;
    check_keys(r, &object, keys);
    number_member(r, &object, "start", OPTIONAL, scene->camera.orthographic ? ANY : POSITIVE, &scene->interval_start);
    number_member(r, &object, "end", OPTIONAL, ANY, &scene->interval_end);
    place end_place = {&object.at, "end", 0};
    if (!(scene->interval_end > scene->interval_start))
        fail(r, &end_place, "must be more than start, which is %g, but is %g", scene->interval_start, scene->interval_end);
    /* What is beyond the far plane is cut off, as if an opaque wall stood there. */
    if (scene->interval_end > scene->camera.far_depth)
        fail(r, &end_place, "must not be beyond the camera's far plane at %g, but is %g", scene->camera.far_depth,
             scene->interval_end);
}

static void read_decay(reader *r, const value *root, demo_scene *scene)
{
    static const char *const keys[] = {"alpha", "beta", NULL};
    scene->decay_alpha = 1;
    scene->decay_beta = 1;
    value object = member(r, root, "decay", OPTIONAL);
    if (!object.json) return;
    check_keys(r, &object, keys);
    number_member(r, &object, "alpha", OPTIONAL, NOT_NEGATIVE, &scene->decay_alpha);
    number_member(r, &object, "beta", OPTIONAL, POSITIVE, &scene->decay_beta);
}

static void read_version_and_comment(reader *r, const value *root)
{
    value version = member(r, root, "version", OPTIONAL), comment = member(r, root, "comment", OPTIONAL);
    if (version.json && !(json_is_number(version.json) && json_number_value(version.json) == 1))
        fail(r, &version.at, "must be 1, the only version there is");
    if (comment.json && !json_is_string(comment.json))
        fail(r, &comment.at, "must be a string, not %s", type_text(comment.json));
}

static void read_scene(reader *r, const value *root, demo_scene *scene)
{
    static const char *const keys[] = {"version",   "comment", "camera", "interval", "decay",  "epsilon", "background", "color",
                                       "composite", "points",  "lines",  "tori",     "curves", "opaque",  NULL};
    static const char *const composites[] = {"lerp", "add", NULL};
    check_keys(r, root, keys);
    read_version_and_comment(r, root);
    read_camera(r, root, &scene->camera);
    read_interval(r, root, scene);
    read_decay(r, root, scene);

    ew_sources_desc *sources = &scene->sources;
    sources->epsilon = 1e-3;
    number_member(r, root, "epsilon", OPTIONAL, POSITIVE, &sources->epsilon);
    vector_member(r, root, "background", OPTIONAL, NOT_NEGATIVE, scene->background);
    vector_copy((double[3]){0.2, 0.5, 1}, scene->color);
    vector_member(r, root, "color", OPTIONAL, NOT_NEGATIVE, scene->color);
    scene->composite = word_member(r, root, "composite", OPTIONAL, composites) == 1 ? EW_OUTPUT_ADD : EW_OUTPUT_LERP;

    r->default_color = scene->color;
    sources->points = list_member(r, root, "points", EW_MAX_POINTS, sizeof(ew_point), read_point, &sources->point_count);
    sources->lines = list_member(r, root, "lines", EW_MAX_LINES, sizeof(ew_line), read_line, &sources->line_count);
    sources->tori = list_member(r, root, "tori", EW_MAX_TORI, sizeof(ew_torus), read_torus, &sources->torus_count);
    sources->curves = list_member(r, root, "curves", EW_MAX_CURVES, sizeof(ew_curve), read_curve, &sources->curve_count);
    scene->opaque = list_member(r, root, "opaque", MAX_OPAQUE_SHAPES, sizeof(opaque_shape), read_opaque, &scene->opaque_count);
}

/* ---- Files -------------------------------------------------------------------------------------------------------------- */

bool scene_parse(const char *text, size_t length, const char *name, demo_scene *scene, char *message, size_t size)
{
    *scene = (demo_scene){0};
    json_error_t error;
    /* Integers are read as reals, so that large ones are as good as any other number. */
    json_t *json = json_loadb(text, length, JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL, &error);
    if (!json) {
        message_write(message, size, "%s: line %d, column %d: %s; mend the JSON there", name, error.line, error.column,
                      error.text);
        return false;
    }
    reader r = {.name = name, .message = message, .size = size, .ok = true};
    value root = {json, {0}};
    if (json_is_object(json))
        read_scene(&r, &root, scene);
    else
        fail(&r, &root.at, "must be a JSON object, not %s", type_text(json));
    json_decref(json);
    if (!r.ok) scene_free(scene);
    return r.ok;
}

/* The file's bytes, to be freed by the caller; NULL with a message. */
static char *read_file(const char *path, size_t *length, char *message, size_t size)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        message_write(message, size, "%s: cannot be opened (%s); name a scene file that exists", path, strerror(errno));
        return NULL;
    }
    char *text = NULL;
    size_t capacity = 0;
    *length = 0;
    do {
        capacity = capacity ? 2 * capacity : 1 << 16;
        char *larger = capacity <= MAX_FILE_BYTES ? realloc(text, capacity) : NULL;
        if (!larger) {
            message_write(message, size, "%s: is too large for a scene file", path);
            break;
        }
        text = larger;
        *length += fread(text + *length, 1, capacity - *length, file);
    } while (*length == capacity);
    bool complete = *length < capacity && !ferror(file);
    if (ferror(file)) message_write(message, size, "%s: cannot be read (%s); name a scene file", path, strerror(errno));
    fclose(file);
    if (complete) return text;
    free(text);
    return NULL;
}

bool scene_load(const char *path, demo_scene *scene, char *message, size_t size)
{
    *scene = (demo_scene){0};
    size_t length;
    char *text = read_file(path, &length, message, size);
    if (!text) return false;
    bool ok = scene_parse(text, length, path, scene, message, size);
    free(text);
    return ok;
}

void scene_free(demo_scene *scene)
{
    /* The library's lists are lists of constants; these were allocated here. */
    for (size_t i = 0; i < scene->sources.curve_count; i++)
        free((double *)scene->sources.curves[i].weights);
    free((ew_point *)scene->sources.points);
    free((ew_line *)scene->sources.lines);
    free((ew_torus *)scene->sources.tori);
    free((ew_curve *)scene->sources.curves);
    free(scene->opaque);
    *scene = (demo_scene){0};
}
