/* Shader permutations: only what a frame needs is compiled. */
#ifndef EW_PROGRAM_H
#define EW_PROGRAM_H

#include "host/gl.h"
#include "model/scene.h"

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

/* The key of the program that draws `mix` as `frame` says, with depth from a texture of `depth_target`, 0 for none. */
unsigned ew_program_key(const ew_mix *mix, const ew_frame_desc *frame, GLenum depth_target);

/* Whether the program of `key` draws all that the one of `other` does, if slower. */
bool ew_program_covers(unsigned key, unsigned other);

/* A program, with the shaders that it is made from as long as it is not ready. */
typedef struct ew_program {
    GLuint name;
    GLuint vertex_shader;
    GLuint fragment_shader;
    bool is_ready;
} ew_program;

/* Starts to make the program of `key`, for a uniform block of `capacity` units of sources. */
ew_result ew_program_start(const ew_gl *gl, size_t capacity, unsigned key, ew_program *program, ew_error *error);

/* Whether ew_program_finish would not wait, as far as the driver can tell. */
bool ew_program_is_complete(const ew_gl *gl, const ew_program *program);

/* Makes a program that was started ready, waiting for the driver if need be; nothing if it is. A program that fails is
 * destroyed. Changes the program in use. */
ew_result ew_program_finish(const ew_gl *gl, ew_program *program, ew_error *error);

void ew_program_destroy(const ew_gl *gl, ew_program *program);

/* Writes the light of a permutation, its picture left out, as text to include into a shader that has a version:
 * zero-terminated. Returns its length; with NULL, does only that. */
size_t ew_program_write_include(size_t capacity, unsigned key, char *text);

#endif
