/* Drawing with the depth of each sample: see sample_passes.h. */
#include "host/sample_passes.h"

void ew_choose_samples(const ew_gl *gl, GLuint program, GLint first, GLint end, GLint surface_rank)
{
    gl->Uniform2i(gl->GetUniformLocation(program, "ew_samples"), first, end);
    gl->Uniform1i(gl->GetUniformLocation(program, "ew_surface_rank"), surface_rank);
}

static void draw_surfaces(const ew_gl *gl, GLuint program, GLint samples, void (*draw)(void *user, GLint surface_rank),
                          void *user)
{
    for (GLint rank = 0; rank < samples; rank++) {
        ew_choose_samples(gl, program, 0, samples, rank);
        draw(user, rank);
    }
}

static void draw_masked(const ew_gl *gl, GLuint program, GLint samples, void (*draw)(void *user, GLint surface_rank),
                        void *user)
{
    gl->Enable(GL_SAMPLE_MASK);
    for (GLint i = 0; i < samples; i++) {
        gl->SampleMaski(0, (GLbitfield)1 << i);
        ew_choose_samples(gl, program, i, i + 1, EW_EVERY_SAMPLE);
        draw(user, 0);
    }
    gl->Disable(GL_SAMPLE_MASK);
}

void ew_draw_samples(const ew_gl *gl, GLuint program, GLint samples, void (*draw)(void *user, GLint surface_rank), void *user)
{
    GLint target_samples = 0;
    gl->GetIntegerv(GL_SAMPLES, &target_samples);
    if (target_samples != samples) {
        ew_choose_samples(gl, program, 0, samples, EW_EVERY_SAMPLE);
        draw(user, 0);
        return;
    }
    if (gl->multisample) gl->Enable(GL_MULTISAMPLE);
    if (gl->sample_mask)
        draw_surfaces(gl, program, samples, draw, user);
    else
        draw_masked(gl, program, samples, draw, user);
}
