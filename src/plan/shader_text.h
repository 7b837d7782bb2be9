/* The text of shaders, put together from the files of glsl/. */
#ifndef EW_SHADER_TEXT_H
#define EW_SHADER_TEXT_H

#include "plan/permutation.h"

/* What a shader's text must fit. */
typedef struct ew_dialect {
    bool es;                 /* OpenGL ES */
    bool sample_mask;        /* shaders know gl_SampleMask */
    bool software;           /* drawn by the processor: see glsl/base/blocks.glsl */
    int max_varying_vectors; /* between the stages */
    size_t capacity;         /* units of sources in the uniform block */
    size_t list_size;        /* of the uniform block of lists, in units */
} ew_dialect;

/* The files of an integrator. They stand behind the base and before the light. */
typedef struct ew_integrator_text {
    const char *const *before; /* before those of the kinds, up to a NULL */
    const char *each_kind;     /* behind those of each kind, with EW_SOURCE defined as its block; NULL for nothing */
    bool is_sampling;          /* takes sample.glsl and the kinds' sampling_files, with EW_SAMPLING defined */
} ew_integrator_text;

/* The most strings that a shader consists of, and the most characters that are made rather than embedded. */
enum { EW_SHADER_MAX_STRINGS = 128, EW_SHADER_MAX_MADE = 8192 };

/* A shader's text: `count` strings, one after the other. Not to be moved: some strings lie in `made`. */
typedef struct ew_shader_text {
    const char *strings[EW_SHADER_MAX_STRINGS];
    int count;
    char made[EW_SHADER_MAX_MADE];
    size_t made_used;
    bool ends_in_made;  /* the last string does */
    bool numbers_lines; /* with #line, for a driver's messages */
    int file_count;
} ew_shader_text;

/* What a program draws: see glsl/pass/. */
typedef enum ew_pass {
    EW_PASS_WAVE,          /* every pixel of the viewport */
    EW_PASS_SURFACES,      /* the light on the opaque scene, at every pixel */
    EW_PASS_MEDIA,         /* the media over the opaque scene, at every pixel */
    EW_PASS_NODES,         /* the light of the grid's nodes */
    EW_PASS_FIELD,         /* the field where the nodes' rays end */
    EW_PASS_PEAK,          /* the largest light of blocks of nodes */
    EW_PASS_CLASSES,       /* the classes of the grid's cells */
    EW_PASS_CELLS,         /* the pixels of the cells that must be integrated */
    EW_PASS_INTERPOLATION, /* those of the other cells */
    EW_PASS_COUNT,
} ew_pass;

/* Whether a pass is one of adaptive resolution. */
static inline bool ew_pass_is_of_grid(ew_pass pass)
{
    return pass != EW_PASS_WAVE && pass != EW_PASS_SURFACES && pass != EW_PASS_MEDIA;
}

/* The part of a key that a pass depends on. */
ew_key ew_permutation_of_pass(ew_pass pass, ew_key key);

void ew_write_vertex_shader(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key);

void ew_write_fragment_shader(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key);

/* EW_PASS_WAVE with an integrator that is none of the library's, for comparisons with it. */
void ew_write_fragment_shader_with(ew_shader_text *text, const ew_dialect *dialect, ew_key key,
                                   const ew_integrator_text *integrator);

/* The light without its picture, to be included into a shader that has a version. */
void ew_write_include(ew_shader_text *text, const ew_dialect *dialect, ew_key key);

/* Joins the strings: zero-terminated. Returns the length; with NULL, does only that. */
size_t ew_join_shader_text(const ew_shader_text *text, char *joined);

#endif
