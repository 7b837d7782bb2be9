/*
 * Reading JSON into numbers and lists, with faults that name their place: "curves[1].weights[3]: must be 0 or more".
 *
 * Only the first fault is reported. After it the functions below do nothing harmful, so the code that reads an object is
 * simply the list of its members.
 */
#ifndef JSON_READER_H
#define JSON_READER_H

#include "memory_chain.h"
#include "printf_format.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct json_reader {
    const char *name;     /* of the file, for messages */
    char *message;        /* receives the first fault */
    size_t size;          /* of `message`, in bytes */
    bool ok;              /* no fault so far */
    memory_chain *memory; /* all lists read; to be freed even after a fault */
    const void *context;  /* for the functions that read a list's elements */
} json_reader;

/* Where a value stands in the file: a member of its parent, by its key; or an element of it, by its index, where the key is
 * NULL. The root has no parent. */
typedef struct json_place {
    const struct json_place *parent;
    const char *key;
    size_t index;
} json_place;

typedef struct json_value {
    const json_t *json; /* NULL where the value is absent */
    json_place at;
} json_value;

typedef enum json_presence { REQUIRED, OPTIONAL } json_presence;
typedef enum json_range { ANY, NOT_NEGATIVE, POSITIVE } json_range;

/* Notes a fault at `at`, unless there is one already. */
PRINTF_FORMAT(3, 4) void reader_fail(json_reader *r, const json_place *at, const char *format, ...);

/* What a value is, as in "must be a number, not an object". */
const char *reader_type_text(const json_value *value);

/* The object's member, or an absent value; it is a fault if a required one is absent. */
json_value reader_member(json_reader *r, const json_value *object, const char *key, json_presence presence);

/* The array's element. */
json_value reader_element(const json_value *array, size_t index);

/* It is a fault if the value is no object; returns whether it is one. */
bool reader_check_object(json_reader *r, const json_value *value);

/* It is a fault if the value is no object, or has keys other than `keys`, which end with NULL. */
void reader_check_keys(json_reader *r, const json_value *value, const char *const *keys);

/* Each of these reads the value itself. */
void reader_number(json_reader *r, const json_value *value, json_range range, double *result);
void reader_vector(json_reader *r, const json_value *value, json_range range, double result[3]);

/* Each of these reads a member of `object`. An optional member that is absent leaves `result` as it is. */
void reader_number_member(json_reader *r, const json_value *object, const char *key, json_presence presence, json_range range,
                          double *result);
void reader_vector_member(json_reader *r, const json_value *object, const char *key, json_presence presence, json_range range,
                          double result[3]);
/* A number from 0 to `most`. */
void reader_factor_member(json_reader *r, const json_value *object, const char *key, json_presence presence, double most,
                          double *result);
/* A required vector that is not zero. */
void reader_direction_member(json_reader *r, const json_value *object, const char *key, double result[3]);
/* Three required vectors. */
void reader_matrix_member(json_reader *r, const json_value *object, const char *key, double result[3][3]);

/* An optional member, which is false by default. */
bool reader_bool_member(json_reader *r, const json_value *object, const char *key);

/* Checks an optional string, which says something to people. */
void reader_text_member(json_reader *r, const json_value *object, const char *key);

/* Returns which of `words`, which end with NULL, the member is; 0 where it is absent or a fault. */
int reader_word_member(json_reader *r, const json_value *object, const char *key, json_presence presence,
                       const char *const *words);

/* Reads one element of a list into `result`, which is zeroed. */
typedef void reader_read_element(json_reader *r, const json_value *element, void *result);

/* Reads an optional list of at most `limit` elements of `element_size` bytes. The result belongs to the reader's memory; it is
 * NULL where the list is empty, absent or a fault. */
void *reader_list_member(json_reader *r, const json_value *object, const char *key, size_t limit, size_t element_size,
                         reader_read_element *read, size_t *count);

#endif
