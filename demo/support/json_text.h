/*
 * JSON as text, in which single values are replaced while all else stays as it was written: order, spaces, names.
 */
#ifndef JSON_TEXT_H
#define JSON_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* One step from a value to one within it: to a member, or, where the key is NULL, to an element. */
typedef struct json_step {
    const char *key;
    size_t index;
} json_step;

typedef struct text_span {
    const char *begin, *end;
} text_span;

enum { JSON_NUMBER_SIZE = 32 };

/* Finds a value in a text that a JSON parser has taken. Keys are compared as they are written, without their escapes. Returns
 * false where it is not there. */
bool json_text_find(const char *text, const json_step *steps, size_t count, text_span *value);

/* Returns the text with this value at the place, which the caller frees. A member that is missing is added behind the object's
 * last, and in its manner. Returns NULL where memory is exhausted, or there is no such place. */
char *json_text_with(const char *text, const json_step *steps, size_t count, const char *value);

/* Writes the number in few digits, but in as many as give it back when they are read. */
void json_text_number(double number, char result[JSON_NUMBER_SIZE]);

#endif
