/* Drawing with the depth of each sample: see sample_passes.h. */
#include "host/sample_passes.h"

void ew_draw_samples(const ew_gl *gl, GLuint program, GLint samples, void (*draw)(void *user), void *user)
{
    GLint target_samples = 0, location = gl->GetUniformLocation(program, "ew_samples");
    gl->GetIntegerv(GL_SAMPLES, &target_samples);
    if (target_samples != samples) {
        gl->Uniform2i(location, 0, samples);
        draw(user);
        return;
    }
    if (gl->multisample) gl->Enable(GL_MULTISAMPLE);
    gl->Enable(GL_SAMPLE_MASK);
    for (GLint i = 0; i < samples; i++) {
        gl->SampleMaski(0, (GLbitfield)1 << i);
        gl->Uniform2i(location, i, i + 1);
        draw(user);
    }
    gl->Disable(GL_SAMPLE_MASK);
}
