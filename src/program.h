/* Shader permutations: only what a frame needs is compiled, and kept. */
#ifndef EW_PROGRAM_H
#define EW_PROGRAM_H

#include "gl.h"
#include "scene.h"

/* What a permutation knows, as bits of its key. Above them stand the numbers of points, lines, tori and curves, in fields of
 * EW_PROGRAM_COUNT_BITS: 0 for none, the number itself up to EW_PROGRAM_MAX_UNROLLED, and one more than that for any. */
enum {
    EW_PROGRAM_WEIGHTS = 1 << 0,
    EW_PROGRAM_DEPTH = 1 << 1,
    EW_PROGRAM_SIMPSON = 1 << 2,
    EW_PROGRAM_LUMINANCE = 1 << 3,
    EW_PROGRAM_EVALUATIONS = 1 << 4,
    EW_PROGRAM_DEPTH_MULTISAMPLE = 1 << 5, /* with EW_PROGRAM_DEPTH */
    EW_PROGRAM_DITHER = 1 << 6,
    EW_PROGRAM_DITHER_SRGB = 1 << 7, /* with EW_PROGRAM_DITHER */
    EW_PROGRAM_FLAG_COUNT = 8,
    EW_PROGRAM_COUNT_BITS = 3,
    EW_PROGRAM_MAX_UNROLLED = 4,
};

/* The programs compiled so far. */
typedef struct ew_program_cache {
    struct ew_cached_program {
        unsigned key;
        GLuint program;
    } * entries;
    size_t count;
    size_t capacity;
} ew_program_cache;

/* The key of the program that draws `scene` as `frame` says. */
unsigned ew_program_key(const ew_scene *scene, const ew_frame_desc *frame);

/* Returns the program of `key` in `program`, compiled if the cache does not hold it, for a uniform block of `capacity` units of
 * sources. Changes the program in use. */
ew_result ew_program_get(ew_program_cache *cache, const ew_gl *gl, size_t capacity, const ew_allocator *allocator, unsigned key,
                         GLuint *program, ew_error *error);

void ew_program_cache_destroy(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator);

#endif
