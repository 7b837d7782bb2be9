/* Drawing with the depth of each sample. */
#ifndef EW_SAMPLE_PASSES_H
#define EW_SAMPLE_PASSES_H

#include "host/gl.h"

/* Calls `draw` for each sample of the target, with that sample masked and its depth read by `program`, which must be in use.
 * Where the target has other samples, calls it once: each pixel then gets the mean over the depth's samples. Masks do what
 * gl_SampleID would, in every context that has multisampled textures. */
void ew_draw_samples(const ew_gl *gl, GLuint program, GLint samples, void (*draw)(void *user), void *user);

#endif
