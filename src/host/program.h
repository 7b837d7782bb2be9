/* A program: the shaders of one permutation, compiled and linked. */
#ifndef EW_PROGRAM_H
#define EW_PROGRAM_H

#include "host/gl.h"
#include "plan/shader_text.h"

/* What shaders for the context must fit. */
ew_dialect ew_gl_dialect(const ew_gl *gl);

/* A program, with the shaders that it is made from as long as it is not ready. */
typedef struct ew_program {
    GLuint name;
    GLuint vertex_shader;
    GLuint fragment_shader;
    bool is_linking; /* or linked */
    bool is_ready;
    bool is_drawn; /* has drawn ahead */
} ew_program;

/* Starts to make the program of a pass and `key`, with the library's own integrator (NULL) or another one: hands its shaders to
 * the compiler. */
ew_result ew_program_start(const ew_gl *gl, ew_pass pass, ew_key key, const ew_integrator_text *integrator, ew_program *program,
                           ew_error *error);

/* Hands the program to the linker, once. */
void ew_program_link(const ew_gl *gl, ew_program *program);

/* Whether ew_program_finish would not wait, as far as the driver can tell. */
bool ew_program_is_complete(const ew_gl *gl, const ew_program *program);

/* Makes a program that was started ready, waiting for the driver if need be; nothing if it is. A program that fails is
 * destroyed. Changes the program in use. */
ew_result ew_program_finish(const ew_gl *gl, ew_program *program, ew_error *error);

void ew_program_destroy(const ew_gl *gl, ew_program *program);

#endif
