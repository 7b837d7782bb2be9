/* The light of sources that are drawn in parts, summed up before it is composited. */
#ifndef EW_LIGHT_SUM_H
#define EW_LIGHT_SUM_H

#include "host/gl.h"
#include "host/state_guard.h"

/* A texture of floats, of which the light fills the first columns and rows. Starts as {0}, and keeps it from frame to frame. */
typedef struct ew_light_sum {
    GLuint texture;
    int width, height;
    bool is_refused; /* the driver cannot draw to it, or it would be too large */
} ew_light_sum;

/* Sums up what `draw` draws of each part, over so many columns and rows, and binds the texture. Changes the draw
 * framebuffer and blending. Returns false if GL cannot: then no sum can be made in this context. */
bool ew_light_sum_fill(ew_light_sum *sum, const ew_gl *gl, int width, int height, int part_count,
                       void (*draw)(void *user, int part), void *user);

void ew_light_sum_destroy(ew_light_sum *sum, const ew_gl *gl);

#endif
