/* The rasteriser's arithmetic limit: see peer_multiply_add.h. */
#include "peer_multiply_add.h"
#include "message.h"
#include "peer_text.h"
#include "shader.h"
#include "stopwatch.h"
#include "texture.h"

#include <math.h>

/* SIDE: of the target, in pixels. OF_A_ROUND: multiply-adds of a pixel. */
enum { SIDE = 512, OF_A_ROUND = 256, FRAMES = 15, MOST_ROUNDS = 1 << 18 };

/* How long a frame should take at least, in milliseconds, so that its start and its end do not count. */
#define LONG_ENOUGH 40.0

static double draw(const gl_functions *gl, bench_stopwatch *stopwatch, GLint location, int rounds)
{
    gl->Uniform1i(location, rounds);
    stopwatch_start(stopwatch);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return stopwatch_stop(stopwatch);
}

static double measure(const gl_functions *gl, bench_stopwatch *stopwatch, GLint location)
{
    int rounds = 1;
    double least = draw(gl, stopwatch, location, rounds);
    while (least < LONG_ENOUGH && rounds < MOST_ROUNDS) {
        rounds *= 2;
        least = draw(gl, stopwatch, location, rounds);
    }
    for (int i = 1; i < FRAMES; i++)
        least = fmin(least, draw(gl, stopwatch, location, rounds));
    return (double)rounds * OF_A_ROUND * SIDE * SIDE / least;
}

double multiply_adds_a_millisecond(gl_context *context, char *message, size_t size)
{
    static const float factor[4] = {0.999f, 0.998f, 0.997f, 0.996f};
    const gl_functions *gl = context_gl(context);
    GLuint program = shader_link(gl, peer_glsl_peer_quad_glsl, peer_glsl_peer_multiply_add_glsl, "multiply-add", message, size);
    if (!program) return 0;
    bool complete = true;
    double rate = 0;
    GLuint vertex_array, texture = texture_create(gl, SIDE, SIDE, GL_R32F, GL_RED);
    GLuint framebuffer = texture_framebuffer(gl, texture, 0, &complete);
    gl->GenVertexArrays(1, &vertex_array);
    if (complete) {
        bench_stopwatch stopwatch = stopwatch_create(context);
        gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl->Viewport(0, 0, SIDE, SIDE);
        gl->UseProgram(program);
        gl->BindVertexArray(vertex_array);
        gl->Uniform4fv(gl->GetUniformLocation(program, "factor"), 1, factor);
        rate = measure(gl, &stopwatch, gl->GetUniformLocation(program, "rounds"));
        gl->BindVertexArray(0);
        gl->UseProgram(0);
        gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
        stopwatch_destroy(&stopwatch);
    } else {
        message_write(message, size, "multiply-add: GL cannot make a float target");
    }
    gl->DeleteProgram(program);
    gl->DeleteTextures(1, &texture);
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->DeleteVertexArrays(1, &vertex_array);
    return rate;
}
