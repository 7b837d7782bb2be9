/* Reading JSON: see json_reader.h. */
#include "json_reader.h"
#include "message.h"
#include "vector.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* The square of this is finite in single precision. */
static const double largest_number = 1e18;

/* ---- Messages ----------------------------------------------------------------------------------------------------------- */

/* Appends a place, such as "curves[1].weights[3]", to `text`, which is `length` long; returns the new length. */
static size_t append_place(const json_place *at, char *text, size_t size, size_t length)
{
    if (!at->parent) return length;
    length = append_place(at->parent, text, size, length);
    if (length >= size) return length;
    int added = at->key ? snprintf(text + length, size - length, "%s%s", length ? "." : "", at->key)
                        : snprintf(text + length, size - length, "[%zu]", at->index);
    return length + (added > 0 ? (size_t)added : 0);
}

void reader_fail(json_reader *r, const json_place *at, const char *format, ...)
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

const char *reader_type_text(const json_value *value)
{
    switch (json_typeof(value->json)) {
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

json_value reader_member(json_reader *r, const json_value *object, const char *key, json_presence presence)
{
    json_value result = {json_object_get(object->json, key), {&object->at, key, 0}};
    if (!result.json && presence == REQUIRED) reader_fail(r, &result.at, "is missing; add it, for it has no default");
    return result;
}

json_value reader_element(const json_value *array, size_t index)
{
    return (json_value){json_array_get(array->json, index), {&array->at, NULL, index}};
}

bool reader_check_object(json_reader *r, const json_value *object)
{
    if (json_is_object(object->json)) return true;
    reader_fail(r, &object->at, "must be an object, not %s", reader_type_text(object));
    return false;
}

void reader_check_keys(json_reader *r, const json_value *object, const char *const *keys)
{
    if (!reader_check_object(r, object)) return;
    const char *key;
    const json_t *ignored;
    json_object_foreach((json_t *)object->json, key, ignored)
    {
        const char *const *known = keys;
        while (*known && strcmp(*known, key) != 0)
            known++;
        if (!*known) {
            json_place at = {&object->at, key, 0};
            char list[200] = "";
            for (known = keys; *known; known++) {
                size_t length = strlen(list);
                snprintf(list + length, sizeof list - length, "%s%s", known == keys ? "" : ", ", *known);
            }
            reader_fail(r, &at, "is not a key of this place, which takes %s", list);
        }
    }
}

static bool check_array(json_reader *r, const json_value *array)
{
    if (json_is_array(array->json)) return true;
    reader_fail(r, &array->at, "must be an array, not %s", reader_type_text(array));
    return false;
}

void reader_number(json_reader *r, const json_value *number, json_range range, double *result)
{
    if (!json_is_number(number->json)) {
        reader_fail(r, &number->at, "must be a number, not %s", reader_type_text(number));
        return;
    }
    double x = json_number_value(number->json);
    if (!(fabs(x) <= largest_number))
        reader_fail(r, &number->at, "must not be larger than %g, but is %g", largest_number, x);
    else if (range == NOT_NEGATIVE && x < 0)
        reader_fail(r, &number->at, "must be 0 or more, but is %g", x);
    else if (range == POSITIVE && x <= 0)
        reader_fail(r, &number->at, "must be more than 0, but is %g", x);
    else
        *result = x;
}

void reader_vector(json_reader *r, const json_value *vector, json_range range, double result[3])
{
    if (!json_is_array(vector->json) || json_array_size(vector->json) != 3) {
        reader_fail(r, &vector->at, "must be an array of 3 numbers");
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        json_value number = reader_element(vector, i);
        reader_number(r, &number, range, &result[i]);
    }
}

void reader_number_member(json_reader *r, const json_value *object, const char *key, json_presence presence, json_range range,
                          double *result)
{
    json_value number = reader_member(r, object, key, presence);
    if (number.json) reader_number(r, &number, range, result);
}

void reader_factor_member(json_reader *r, const json_value *object, const char *key, json_presence presence, double most,
                          double *result)
{
    json_value number = reader_member(r, object, key, presence);
    if (!number.json) return;
    reader_number(r, &number, NOT_NEGATIVE, result);
    if (*result > most) reader_fail(r, &number.at, "must be from 0 to %g, but is %g", most, *result);
}

void reader_vector_member(json_reader *r, const json_value *object, const char *key, json_presence presence, json_range range,
                          double result[3])
{
    json_value vector = reader_member(r, object, key, presence);
    if (vector.json) reader_vector(r, &vector, range, result);
}

void reader_direction_member(json_reader *r, const json_value *object, const char *key, double result[3])
{
    json_value vector = reader_member(r, object, key, REQUIRED);
    double ignored[3];
    if (!vector.json) return;
    reader_vector(r, &vector, ANY, result);
    if (r->ok && !vector_normalize(result, ignored)) reader_fail(r, &vector.at, "must not be zero: it gives a direction");
}

void reader_matrix_member(json_reader *r, const json_value *object, const char *key, double result[3][3])
{
    json_value matrix = reader_member(r, object, key, REQUIRED);
    if (!matrix.json) return;
    if (!json_is_array(matrix.json) || json_array_size(matrix.json) != 3) {
        reader_fail(r, &matrix.at, "must be an array of 3 points");
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        json_value row = reader_element(&matrix, i);
        reader_vector(r, &row, ANY, result[i]);
    }
}

bool reader_bool_member(json_reader *r, const json_value *object, const char *key)
{
    json_value value = reader_member(r, object, key, OPTIONAL);
    if (value.json && !json_is_boolean(value.json))
        reader_fail(r, &value.at, "must be true or false, not %s", reader_type_text(&value));
    return json_is_true(value.json);
}

void reader_text_member(json_reader *r, const json_value *object, const char *key)
{
    json_value text = reader_member(r, object, key, OPTIONAL);
    if (text.json && !json_is_string(text.json)) reader_fail(r, &text.at, "must be a string, not %s", reader_type_text(&text));
}

int reader_word_member(json_reader *r, const json_value *object, const char *key, json_presence presence,
                       const char *const *words)
{
    json_value word = reader_member(r, object, key, presence);
    if (!word.json) return 0;
    if (json_is_string(word.json))
        for (int i = 0; words[i]; i++)
            if (strcmp(words[i], json_string_value(word.json)) == 0) return i;
    char list[100] = "";
    for (int i = 0; words[i]; i++) {
        size_t length = strlen(list);
        snprintf(list + length, sizeof list - length, "%s\"%s\"", i ? " or " : "", words[i]);
    }
    reader_fail(r, &word.at, "must be %s", list);
    return 0;
}

void *reader_list_member(json_reader *r, const json_value *object, const char *key, size_t limit, size_t element_size,
                         reader_read_element *read, size_t *count)
{
    *count = 0;
    json_value list = reader_member(r, object, key, OPTIONAL);
    if (!list.json || !check_array(r, &list)) return NULL;
    size_t length = json_array_size(list.json);
    if (length == 0) return NULL;
    if (length > limit) {
        reader_fail(r, &list.at, "must have %zu elements at most, but has %zu", limit, length);
        return NULL;
    }
    unsigned char *elements = memory_chain_allocate(&r->memory, length, element_size);
    if (!elements) {
        reader_fail(r, &list.at, "does not fit into memory");
        return NULL;
    }
    *count = length;
    for (size_t i = 0; i < length && r->ok; i++) {
        json_value item = reader_element(&list, i);
        read(r, &item, elements + i * element_size);
    }
    return elements;
}
