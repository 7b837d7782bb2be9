/* Changes to one part: see scene_edit.h. */
#include "scene_edit.h"
#include "json_text.h"

#include <stdio.h>

enum { JSON_VECTOR_SIZE = 3 * JSON_NUMBER_SIZE + 8 };

static bool find_member(const char *text, scene_part part, const char *key, text_span *value)
{
    const json_step steps[] = {{.key = scene_part_list(part.kind)}, {.index = part.index}, {.key = key}};
    return json_text_find(text, steps, 3, value);
}

bool scene_edit_has(const char *text, scene_part part, const char *key)
{
    text_span value;
    return find_member(text, part, key, &value);
}

char *scene_edit_set_number(const char *text, scene_part part, const char *key, double number)
{
    const json_step steps[] = {{.key = scene_part_list(part.kind)}, {.index = part.index}, {.key = key}};
    char value[JSON_NUMBER_SIZE];
    json_text_number(number, value);
    return json_text_with(text, steps, 3, value);
}

static void write_vector(const double vector[3], char value[JSON_VECTOR_SIZE])
{
    char numbers[3][JSON_NUMBER_SIZE];
    for (int i = 0; i < 3; i++)
        json_text_number(vector[i] + 0.0, numbers[i]); /* no -0 */
    snprintf(value, JSON_VECTOR_SIZE, "[%s, %s, %s]", numbers[0], numbers[1], numbers[2]);
}

char *scene_edit_set_vector(const char *text, scene_part part, const char *key, const double vector[3])
{
    const json_step steps[] = {{.key = scene_part_list(part.kind)}, {.index = part.index}, {.key = key}};
    char value[JSON_VECTOR_SIZE];
    write_vector(vector, value);
    return json_text_with(text, steps, 3, value);
}

char *scene_edit_set_element(const char *text, scene_part part, const char *key, size_t element, const double vector[3])
{
    const json_step steps[] = {{.key = scene_part_list(part.kind)}, {.index = part.index}, {.key = key}, {.index = element}};
    char value[JSON_VECTOR_SIZE];
    write_vector(vector, value);
    return json_text_with(text, steps, 4, value);
}

void scene_edit_title(const char *text, scene_part part, char *title, size_t size)
{
    text_span name;
    if (find_member(text, part, "name", &name) && name.end - name.begin > 2)
        snprintf(title, size, "%.*s", (int)(name.end - name.begin - 2), name.begin + 1);
    else
        snprintf(title, size, "%s[%zu]", scene_part_list(part.kind), part.index);
}
