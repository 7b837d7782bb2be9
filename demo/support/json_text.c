/* Values replaced in JSON: see json_text.h. */
#include "json_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char spaces[] = " \t\r\n";

static const char *skip_spaces(const char *at)
{
    return at + strspn(at, spaces);
}

/* From a string's first quote to behind its last. */
static const char *skip_string(const char *at)
{
    for (at++; *at && *at != '"'; at++)
        if (*at == '\\' && at[1]) at++;
    return *at ? at + 1 : at;
}

static const char *skip_value(const char *at)
{
    size_t depth = 0;
    do {
        if (*at == '"') {
            at = skip_string(at);
        } else if (*at == '{' || *at == '[') {
            depth++;
            at++;
        } else if (depth > 0 && (*at == '}' || *at == ']')) {
            depth--;
            at++;
        } else {
            /* A number or a word; inside of arrays and objects, also what stands between values. */
            at += strcspn(at, depth ? "\"{}[]" : ",]} \t\r\n");
        }
    } while (depth > 0 && *at);
    return at;
}

/* Whether a key, with its quotes, is the one that is looked for. */
static bool is_key(const char *written, const char *end, const char *key)
{
    size_t length = strlen(key);
    return (size_t)(end - written) == length + 2 && memcmp(written + 1, key, length) == 0;
}

static bool find_member(const char *object, const char *key, text_span *value)
{
    if (*object != '{') return false;
    const char *at = skip_spaces(object + 1);
    while (*at == '"') {
        const char *key_end = skip_string(at);
        const char *begin = skip_spaces(key_end);
        if (*begin != ':') return false;
        begin = skip_spaces(begin + 1);
        *value = (text_span){begin, skip_value(begin)};
        if (is_key(at, key_end, key)) return true;
        at = skip_spaces(value->end);
        if (*at == ',') at = skip_spaces(at + 1);
    }
    return false;
}

static bool find_element(const char *array, size_t index, text_span *value)
{
    if (*array != '[') return false;
    const char *at = skip_spaces(array + 1);
    while (*at && *at != ']') {
        *value = (text_span){at, skip_value(at)};
        if (index-- == 0) return true;
        at = skip_spaces(value->end);
        if (*at == ',') at = skip_spaces(at + 1);
    }
    return false;
}

bool json_text_find(const char *text, const json_step *steps, size_t count, text_span *value)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    if (strncmp(text, byte_order_mark, strlen(byte_order_mark)) == 0) text += strlen(byte_order_mark);
    text = skip_spaces(text);
    *value = (text_span){text, skip_value(text)};
    for (size_t i = 0; i < count; i++) {
        const char *parent = value->begin;
        if (!(steps[i].key ? find_member(parent, steps[i].key, value) : find_element(parent, steps[i].index, value)))
            return false;
    }
    return true;
}

/* The text up to `cut.begin`, then the pieces, then the text from `cut.end` on. */
static char *splice(const char *text, text_span cut, const text_span *pieces, size_t count)
{
    size_t length = (size_t)(cut.begin - text) + strlen(cut.end);
    for (size_t i = 0; i < count; i++)
        length += (size_t)(pieces[i].end - pieces[i].begin);
    char *result = malloc(length + 1), *end = result;
    if (!result) return NULL;
    memcpy(end, text, (size_t)(cut.begin - text));
    end += cut.begin - text;
    for (size_t i = 0; i < count; i++) {
        memcpy(end, pieces[i].begin, (size_t)(pieces[i].end - pieces[i].begin));
        end += pieces[i].end - pieces[i].begin;
    }
    strcpy(end, cut.end);
    return result;
}

static text_span span_of(const char *text)
{
    return (text_span){text, text + strlen(text)};
}

/* The new member stands behind the last one, after the same spaces as that. */
static char *with_member(const char *text, text_span object, const char *key, const char *value)
{
    if (*object.begin != '{') return NULL;
    text_span space = {object.begin + 1, skip_spaces(object.begin + 1)};
    const char *end = NULL, *at = space.end;
    while (*at == '"') {
        at = skip_spaces(skip_string(at));
        if (*at != ':') return NULL;
        end = skip_value(skip_spaces(at + 1));
        at = skip_spaces(end);
        if (*at != ',') break;
        space = (text_span){at + 1, skip_spaces(at + 1)};
        at = space.end;
    }
    text_span pieces[] = {span_of(end ? "," : ""), end ? space : span_of(""), span_of("\""), span_of(key), span_of("\": "),
                          span_of(value)};
    const char *place = end ? end : object.begin + 1;
    return splice(text, (text_span){place, place}, pieces, sizeof pieces / sizeof *pieces);
}

char *json_text_with(const char *text, const json_step *steps, size_t count, const char *value)
{
    text_span span, piece = span_of(value);
    if (json_text_find(text, steps, count, &span)) return splice(text, span, &piece, 1);
    if (count == 0 || !steps[count - 1].key || !json_text_find(text, steps, count - 1, &span)) return NULL;
    return with_member(text, span, steps[count - 1].key, value);
}

void json_text_number(double number, char result[JSON_NUMBER_SIZE])
{
    int digits = 6; /* fewer would write 250 as 2.5e+02 */
    do
        snprintf(result, JSON_NUMBER_SIZE, "%.*g", digits, number);
    while (strtod(result, NULL) != number && ++digits <= 17);
}
