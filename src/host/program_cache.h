/* The programs that are compiled, and those still compiling. */
#ifndef EW_PROGRAM_CACHE_H
#define EW_PROGRAM_CACHE_H

#include "host/program.h"

/* The programs of one pass. */
typedef struct ew_program_cache {
    ew_pass pass;
    struct ew_cached_program {
        ew_key key;
        ew_program program;
    } * entries;
    size_t count;
    size_t capacity;
} ew_program_cache;

/* Takes one step towards the program of `key`: hands its shaders to the compiler, or the program to the linker, or makes it
 * ready. `name` receives its name if it is ready, or else 0, and `steps_left` how many steps are left. Waits only if the driver
 * cannot say whether a program is ready. Changes the program in use. */
ew_result ew_program_prepare(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, ew_key key, GLuint *name,
                             int *steps_left, ew_error *error);

/* Whether a program for `key` is ready, or one that is more general. */
bool ew_program_is_ready(const ew_program_cache *cache, ew_key key);

/* How many steps it is until the program of `key` has drawn ahead, of which the last is to make it ready and draw. */
int ew_program_steps(const ew_program_cache *cache, ew_key key);

/* Says so of a ready program. */
void ew_program_set_drawn(ew_program_cache *cache, GLuint name);

/* Finds a ready program for `key`, or a ready one that is more general, or else compiles that of `key` and waits for it. `name`
 * receives its name. Changes the program in use. */
ew_result ew_program_get(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, ew_key key, GLuint *name,
                         ew_error *error);

/* Deletes the programs. The list is left to ew_program_cache_abandon. */
void ew_program_cache_destroy(ew_program_cache *cache, const ew_gl *gl);

/* Frees the list. Calls no GL. */
void ew_program_cache_abandon(ew_program_cache *cache, const ew_allocator *allocator);

#endif
