/* The programs compiled so far, and those under way. */
#ifndef EW_PROGRAM_CACHE_H
#define EW_PROGRAM_CACHE_H

#include "host/program.h"

typedef struct ew_program_cache {
    struct ew_cached_program {
        unsigned key;
        ew_program program;
    } * entries;
    size_t count;
    size_t capacity;
} ew_program_cache;

/* Starts to make the program of `key`, unless the cache holds it. Returns its
 * name in `name` if it is ready, and else 0, without waiting where the driver can tell. Changes the program in use. */
ew_result ew_program_prepare(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, unsigned key,
                             GLuint *name, ew_error *error);

/* Returns the name of a program that draws what the one of `key` would: that one, or a more general one if it is not ready; if
 * there is none of either, waits for it. Changes the program in use. */
ew_result ew_program_get(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, unsigned key, GLuint *name,
                         ew_error *error);

void ew_program_cache_destroy(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator);

#endif
