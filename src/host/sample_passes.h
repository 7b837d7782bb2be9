/* Drawing with the depth of each sample. */
#ifndef EW_SAMPLE_PASSES_H
#define EW_SAMPLE_PASSES_H

#include "host/gl.h"

/* In place of a rank: a program shades each of the chosen samples as it is, and writes their mean; or it takes them for one
 * surface, and shades that. */
enum { EW_EVERY_SAMPLE = -1, EW_ONE_SURFACE = -2 };

/* Tells a program in use which of the depth's samples it shades, and which of the surfaces that a pixel sees: see
 * glsl/pass/samples.glsl. */
void ew_choose_samples(const ew_gl *gl, GLuint program, GLint first, GLint end, GLint surface_rank);

/* Calls `draw` so that `program`, which must be in use, shades each surface that a pixel's samples see: for the first surface
 * of every pixel, whose rank is 0, then for the second one of those that have more, and so on. Where shaders cannot say which
 * samples they write, calls it for each sample, with that sample masked. Where the target has other samples than the depth,
 * calls it once: each pixel then gets the mean over the depth's samples. These calls are of rank 0, too. */
void ew_draw_samples(const ew_gl *gl, GLuint program, GLint samples, void (*draw)(void *user, GLint surface_rank), void *user);

#endif
