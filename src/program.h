/* Shader permutations: only what a frame needs is compiled, and kept. */
#ifndef EW_PROGRAM_H
#define EW_PROGRAM_H

#include "gl.h"
#include "scene.h"

/* What a permutation knows: bits that together make its key. */
enum {
    EW_PROGRAM_POINTS = 1 << 0,
    EW_PROGRAM_LINES = 1 << 1,
    EW_PROGRAM_TORI = 1 << 2,
    EW_PROGRAM_CURVES = 1 << 3,
    EW_PROGRAM_WEIGHTS = 1 << 4,
    EW_PROGRAM_DEPTH = 1 << 5,
    EW_PROGRAM_SIMPSON = 1 << 6,
    EW_PROGRAM_LUMINANCE = 1 << 7,
    EW_PROGRAM_EVALUATIONS = 1 << 8,
    EW_PROGRAM_KEY_COUNT = 1 << 9,
};

typedef struct ew_program_cache {
    GLuint programs[EW_PROGRAM_KEY_COUNT]; /* by key; 0: not compiled yet */
} ew_program_cache;

/* The key of the program that draws `scene` as `frame` says. */
unsigned ew_program_key(const ew_scene *scene, const ew_frame_desc *frame);

/* Returns the program of `key` in `program`, compiled if the cache does not hold it. Changes the program in use. */
ew_result ew_program_get(ew_program_cache *cache, const ew_gl *gl, const ew_capacity *capacity, unsigned key, GLuint *program,
                         ew_error *error);

void ew_program_cache_destroy(ew_program_cache *cache, const ew_gl *gl);

#endif
