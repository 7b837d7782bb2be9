/* The scene file: see scene_file.h. */
#include "scene_file.h"
#include "json_reader.h"
#include "message.h"
#include "scene_shapes.h"
#include "scene_sources.h"
#include "vector.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FILE_BYTES = 64 << 20 };

static void check_camera(json_reader *r, const json_value *object, const scene_camera *camera)
{
    double direction[3], up[3], right[3];
    json_place target_place = {&object->at, "target", 0}, up_place = {&object->at, "up", 0};
    json_place fov_place = {&object->at, "fov_y_degrees", 0}, far_place = {&object->at, "far", 0};
    vector_subtract(camera->target, camera->eye, direction);
    if (!vector_normalize(direction, direction)) {
        reader_fail(r, &target_place, "must not be where the camera's eye is");
        return;
    }
    if (!vector_normalize(camera->up, up)) {
        reader_fail(r, &up_place, "must not be zero: it gives a direction");
        return;
    }
    vector_cross(direction, up, right);
    if (vector_length(right) < 1e-6) reader_fail(r, &up_place, "must not point along the view, from eye to target");
    if (camera->fov_y_degrees < 1e-3 || camera->fov_y_degrees > 179)
        reader_fail(r, &fov_place, "must be from 0.001 to 179, but is %g", camera->fov_y_degrees);
    if (!(camera->far_depth > camera->near_depth))
        reader_fail(r, &far_place, "must be more than near, which is %g, but is %g", camera->near_depth, camera->far_depth);
}

static void read_camera(json_reader *r, const json_value *root, scene_camera *camera)
{
    static const char *const perspective_keys[] = {"projection", "eye", "target", "up", "fov_y_degrees", "near", "far", NULL};
    static const char *const orthographic_keys[] = {"projection", "eye", "target", "up", "height", "near", "far", NULL};
    static const char *const projections[] = {"perspective", "orthographic", NULL};
    *camera = (scene_camera){.up = {0, 1, 0}, .fov_y_degrees = 45, .height = 2, .near_depth = 0.1, .far_depth = 100};
    json_value object = reader_member(r, root, "camera", REQUIRED);
    if (!object.json || !reader_check_object(r, &object)) return;
    camera->orthographic = reader_word_member(r, &object, "projection", OPTIONAL, projections) == 1;
    reader_check_keys(r, &object, camera->orthographic ? orthographic_keys : perspective_keys);
    reader_vector_member(r, &object, "eye", REQUIRED, ANY, camera->eye);
    reader_vector_member(r, &object, "target", REQUIRED, ANY, camera->target);
    reader_vector_member(r, &object, "up", OPTIONAL, ANY, camera->up);
    reader_number_member(r, &object, "fov_y_degrees", OPTIONAL, POSITIVE, &camera->fov_y_degrees);
    reader_number_member(r, &object, "height", OPTIONAL, POSITIVE, &camera->height);
    reader_number_member(r, &object, "near", OPTIONAL, camera->orthographic ? ANY : POSITIVE, &camera->near_depth);
    reader_number_member(r, &object, "far", OPTIONAL, ANY, &camera->far_depth);
    if (r->ok) check_camera(r, &object, camera);
}

/* Without an interval, both of its ends stay 0. */
static void read_interval(json_reader *r, const json_value *root, demo_scene *scene)
{
    static const char *const keys[] = {"start", "end", NULL};
    json_value object = reader_member(r, root, "interval", OPTIONAL);
    if (!object.json) return;
    scene->interval_start = scene->camera.near_depth;
    scene->interval_end = scene->camera.far_depth;
    reader_check_keys(r, &object, keys);
    reader_number_member(r, &object, "start", OPTIONAL, scene->camera.orthographic ? ANY : POSITIVE, &scene->interval_start);
    reader_number_member(r, &object, "end", OPTIONAL, ANY, &scene->interval_end);
    json_place end_place = {&object.at, "end", 0};
    if (!(scene->interval_end > scene->interval_start))
        reader_fail(r, &end_place, "must be more than start, which is %g, but is %g", scene->interval_start,
                    scene->interval_end);
    /* The far plane acts as an opaque wall: no light would come from beyond it. */
    if (scene->interval_end > scene->camera.far_depth)
        reader_fail(r, &end_place, "must not be beyond the camera's far plane at %g, but is %g", scene->camera.far_depth,
                    scene->interval_end);
}

static void read_decay(json_reader *r, const json_value *root, demo_scene *scene)
{
    static const char *const keys[] = {"alpha", "beta", NULL};
    scene->decay_alpha = 1;
    scene->decay_beta = 1;
    json_value object = reader_member(r, root, "decay", OPTIONAL);
    if (!object.json) return;
    if (scene_is_world(scene))
        reader_fail(r, &object.at, "must not be there without an interval; add an interval, or leave the decay out");
    reader_check_keys(r, &object, keys);
    reader_number_member(r, &object, "alpha", OPTIONAL, NOT_NEGATIVE, &scene->decay_alpha);
    reader_number_member(r, &object, "beta", OPTIONAL, POSITIVE, &scene->decay_beta);
}

static void read_version_and_comment(json_reader *r, const json_value *root)
{
    json_value version = reader_member(r, root, "version", OPTIONAL);
    if (version.json && !(json_is_number(version.json) && json_number_value(version.json) == 1))
        reader_fail(r, &version.at, "must be 1, the only version there is");
    reader_text_member(r, root, "comment");
}

static void check_root_keys(json_reader *r, const json_value *root)
{
    static const char *const fixed[] = {"version",   "comment",     "camera",   "interval",   "decay",
                                        "epsilon",   "core_pixels", "exposure", "background", "color",
                                        "composite", "opaque",      "light",    "fog",        "media"};
    enum { FIXED_COUNT = sizeof fixed / sizeof *fixed };
    const char *keys[FIXED_COUNT + SCENE_SOURCE_KIND_COUNT + 1] = {NULL};
    for (int i = 0; i < FIXED_COUNT; i++)
        keys[i] = fixed[i];
    for (int i = 0; i < SCENE_SOURCE_KIND_COUNT; i++)
        keys[FIXED_COUNT + i] = scene_source_kinds[i].key;
    reader_check_keys(r, root, keys);
}

/* How the sources light the opaque shapes; without it, they do not. */
static void read_light(json_reader *r, const json_value *root, demo_scene *scene)
{
    static const char *const keys[] = {"gain", "reach", "shadow_thickness", NULL};
    scene->light_gain = 1;
    json_value object = reader_member(r, root, "light", OPTIONAL);
    if (!object.json) return;
    reader_check_keys(r, &object, keys);
    reader_factor_member(r, &object, "gain", OPTIONAL, 1e6, &scene->light_gain);
    reader_number_member(r, &object, "reach", REQUIRED, POSITIVE, &scene->light_reach);
    reader_factor_member(r, &object, "shadow_thickness", OPTIONAL, 1e18, &scene->shadow_thickness);
}

/* Without a height, the fog is the same everywhere. */
static void read_fog(json_reader *r, const json_value *root, ew_fog *fog)
{
    static const char *const keys[] = {"extinction", "height", NULL};
    static const char *const height_keys[] = {"base", "scale", "up", NULL};
    vector_copy((double[3]){0, 1, 0}, fog->up);
    json_value object = reader_member(r, root, "fog", OPTIONAL);
    if (!object.json) return;
    reader_check_keys(r, &object, keys);
    reader_factor_member(r, &object, "extinction", REQUIRED, 1e12, &fog->extinction);
    json_value height = reader_member(r, &object, "height", OPTIONAL);
    if (!height.json) return;
    reader_check_keys(r, &height, height_keys);
    reader_number_member(r, &height, "base", OPTIONAL, ANY, &fog->base);
    reader_number_member(r, &height, "scale", REQUIRED, POSITIVE, &fog->scale);
    if (reader_member(r, &height, "up", OPTIONAL).json) reader_direction_member(r, &height, "up", fog->up);
}

static void read_look(json_reader *r, const json_value *root, demo_scene *scene)
{
    static const char *const names[] = {"lerp", "add", "soft", NULL};
    static const ew_output composites[] = {EW_OUTPUT_LERP, EW_OUTPUT_ADD, EW_OUTPUT_SOFT};
    scene->composite = composites[reader_word_member(r, root, "composite", OPTIONAL, names)];
    scene->core_pixels = scene_is_world(scene) ? 1.5 : 0;
    reader_factor_member(r, root, "core_pixels", OPTIONAL, 64, &scene->core_pixels);
    scene->exposure = 1;
    reader_factor_member(r, root, "exposure", OPTIONAL, 1e6, &scene->exposure);
    read_light(r, root, scene);
    read_fog(r, root, &scene->fog);
    reader_vector_member(r, root, "background", OPTIONAL, NOT_NEGATIVE, scene->background);
    vector_copy((double[3]){0.2, 0.5, 1}, scene->color);
    reader_vector_member(r, root, "color", OPTIONAL, NOT_NEGATIVE, scene->color);
}

static void read_scene(json_reader *r, const json_value *root, demo_scene *scene)
{
    check_root_keys(r, root);
    read_version_and_comment(r, root);
    read_camera(r, root, &scene->camera);
    read_interval(r, root, scene);
    read_decay(r, root, scene);
    read_look(r, root, scene);
    scene_read_opaque(r, root, scene);
    scene_read_media(r, root, scene);

    scene->sources.epsilon = 1e-3;
    reader_number_member(r, root, "epsilon", OPTIONAL, POSITIVE, &scene->sources.epsilon);
    r->context = scene;
    for (int i = 0; i < SCENE_SOURCE_KIND_COUNT; i++)
        scene_source_kinds[i].read(r, root, &scene->sources);
}

/* ---- Files -------------------------------------------------------------------------------------------------------------- */

/* UTF-16 begins with a byte order mark, or with a character of ASCII, of which one byte is 0. */
static bool is_utf16(const char *text, size_t length)
{
    return length >= 2 &&
           (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0 || (text[0] == '\0') != (text[1] == '\0'));
}

bool scene_parse(const char *text, size_t length, const char *name, demo_scene *scene, char *message, size_t size)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    enum { MARK_LENGTH = sizeof byte_order_mark - 1 };
    *scene = (demo_scene){0};
    if (is_utf16(text, length)) {
        message_write(message, size, "%s: is UTF-16 text; save it as UTF-8", name);
        return false;
    }
    if (length >= MARK_LENGTH && memcmp(text, byte_order_mark, MARK_LENGTH) == 0) {
        text += MARK_LENGTH;
        length -= MARK_LENGTH;
    }
    json_error_t error;
    /* Integers are read as reals, because large ones would not fit into an integer. */
    json_t *json = json_loadb(text, length, JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL, &error);
    if (!json) {
        message_write(message, size, "%s: line %d, column %d: %s; mend the JSON there", name, error.line, error.column,
                      error.text);
        return false;
    }
    json_reader r = {.name = name, .message = message, .size = size, .ok = true};
    json_value root = {json, {0}};
    if (json_is_object(json))
        read_scene(&r, &root, scene);
    else
        reader_fail(&r, &root.at, "must be a JSON object, not %s", reader_type_text(&root));
    json_decref(json);
    scene->memory = r.memory;
    if (!r.ok) scene_free(scene);
    return r.ok;
}

char *scene_read_text(const char *path, size_t *length, char *message, size_t size)
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
    if (complete) {
        text[*length] = '\0';
        return text;
    }
    free(text);
    return NULL;
}

bool scene_load(const char *path, demo_scene *scene, char *message, size_t size)
{
    *scene = (demo_scene){0};
    size_t length;
    char *text = scene_read_text(path, &length, message, size);
    if (!text) return false;
    bool ok = scene_parse(text, length, path, scene, message, size);
    free(text);
    return ok;
}

void scene_free(demo_scene *scene)
{
    memory_chain_free(&scene->memory);
    *scene = (demo_scene){0};
}
