/* A field with a bright core, the effect that draws it, and the truth about it. */
#ifndef TEST_GLOW_H
#define TEST_GLOW_H

#include "context.h"
#include "energywave.h"

enum { GLOW_WIDTH = 48, GLOW_HEIGHT = 36 };

/* One of each kind of source, around the origin. */
extern const ew_sources_desc glow_sources;

/* An effect with these sources, for the current context. */
ew_effect *glow_create(gl_context *context);

/* A frame that sees them, of the size above, from (0, 0, 6), drawn to `framebuffer`. */
ew_frame_desc glow_frame(unsigned framebuffer);

/* Draws, and fails the test where the effect does. */
void glow_draw(ew_effect *effect, const ew_frame_desc *frame);

/* Draws, and expects a refusal whose text names `field`. */
void glow_refuse(ew_effect *effect, const ew_frame_desc *frame, ew_result result, const char *field);

/* What the camera sees at `depth` before it is at (x, y) of the picture plane at depth 1 (perspective), or (x, y) itself. */
typedef struct glow_lens {
    bool parallel;
    double left, right, bottom, top;
} glow_lens;

extern const glow_lens glow_default_lens;

/* The centre of the pixel (column, row) on the picture plane. */
void glow_pixel(const glow_lens *lens, int column, int row, double place[2]);

/* Projections of a lens: clip z is `z_scale` z + `z_offset` in view space, and w -z, or 1 for a parallel one. */
void glow_projection(const glow_lens *lens, double z_scale, double z_offset, double projection[16]);

/* The luminance of a pixel whose ray ends at the view depth `opaque`, by the reference. */
double glow_reference(const glow_lens *lens, const ew_frame_desc *frame, int column, int row, double opaque);

#endif
