/* Changes to one source: see scene_edit.h. */
#include "scene_edit.h"
#include "json_text.h"
#include "vector.h"

#include <stdio.h>

static const char *const lists[SOURCE_KIND_COUNT] = {[SOURCE_POINT] = "points",
                                                     [SOURCE_LINE] = "lines",
                                                     [SOURCE_TORUS] = "tori",
                                                     [SOURCE_CURVE] = "curves",
                                                     [SOURCE_PATH] = "paths"};

static bool find_member(const char *text, source_part part, const char *key, text_span *value)
{
    return json_text_find(text, (json_step[]){{.key = lists[part.kind]}, {.index = part.index}, {.key = key}}, 3, value);
}

bool scene_edit_has(const char *text, source_part part, const char *key)
{
    text_span value;
    return find_member(text, part, key, &value);
}

/* A curve that is given by its polynomial has one position, which moves all of it. */
static bool has_control_points(const char *text, source_part part)
{
    return scene_edit_has(text, part, "control_points");
}

size_t scene_edit_point_count(const demo_scene *scene, const char *text, source_part part)
{
    if (part.kind == SOURCE_CURVE) return has_control_points(text, part) ? 3 : 1;
    return part.kind == SOURCE_PATH ? scene->sources.paths[part.index].point_count : 1;
}

void scene_edit_point(const demo_scene *scene, source_part part, size_t point, double position[3])
{
    const ew_sources_desc *sources = &scene->sources;
    switch (part.kind) {
    case SOURCE_POINT:
        vector_copy(sources->points[part.index].position, position);
        break;
    case SOURCE_LINE:
        vector_copy(sources->lines[part.index].position, position);
        break;
    case SOURCE_TORUS:
        vector_copy(sources->tori[part.index].center, position);
        break;
    case SOURCE_CURVE: {
        const double(*polynomial)[3] = sources->curves[part.index].polynomial;
        /* The control points are C0, C0 + C1 / 2, and C0 + C1 + C2. */
        vector_add_scaled(polynomial[0], 0.5 * (double)point, polynomial[1], position);
        if (point == 2) vector_add_scaled(position, 1, polynomial[2], position);
        break;
    }
    case SOURCE_PATH:
        vector_copy(sources->paths[part.index].points[point], position);
        break;
    }
}

char *scene_edit_move_point(const char *text, source_part part, size_t point, const double position[3], double step)
{
    static const char *const members[SOURCE_KIND_COUNT] = {[SOURCE_POINT] = "position",
                                                           [SOURCE_LINE] = "position",
                                                           [SOURCE_TORUS] = "center",
                                                           [SOURCE_CURVE] = "polynomial",
                                                           [SOURCE_PATH] = "points"};
    char numbers[3][JSON_NUMBER_SIZE], value[3 * JSON_NUMBER_SIZE + 8];
    const char *member = members[part.kind];
    if (part.kind == SOURCE_CURVE && has_control_points(text, part)) member = "control_points";
    /* Dividing by the inverse, a whole number where steps are small, gives the decimal's own double. */
    for (int i = 0; i < 3; i++) {
        double rounded = step < 1 ? round(position[i] * round(1 / step)) / round(1 / step) : round(position[i] / step) * step;
        json_text_number(rounded + 0.0, numbers[i]); /* no -0 */
    }
    snprintf(value, sizeof value, "[%s, %s, %s]", numbers[0], numbers[1], numbers[2]);
    const json_step steps[] = {{.key = lists[part.kind]}, {.index = part.index}, {.key = member}, {.index = point}};
    bool is_listed = part.kind == SOURCE_CURVE || part.kind == SOURCE_PATH;
    return json_text_with(text, steps, is_listed ? 4 : 3, value);
}

char *scene_edit_set_number(const char *text, source_part part, const char *key, double number)
{
    char value[JSON_NUMBER_SIZE];
    json_text_number(number, value);
    return json_text_with(text, (json_step[]){{.key = lists[part.kind]}, {.index = part.index}, {.key = key}}, 3, value);
}

void scene_edit_title(const char *text, source_part part, char *title, size_t size)
{
    text_span name;
    if (find_member(text, part, "name", &name) && name.end - name.begin > 2)
        snprintf(title, size, "%.*s", (int)(name.end - name.begin - 2), name.begin + 1);
    else
        snprintf(title, size, "%s[%zu]", lists[part.kind], part.index);
}
