/*
 * Marching at half the resolution, as engines draw fog: interleaved offsets (peer_interleaved.glsl), and depth-aware upsampling
 * (peer_half_upsample.glsl). Engines filter over frames as well, which is left out, since it needs a still picture.
 */
#ifndef PEER_HALF_H
#define PEER_HALF_H

#include "context.h"

typedef struct peer_half peer_half;

/* NULL with a message on failure. */
peer_half *peer_half_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                            size_t size);
void peer_half_destroy(peer_half *peer);

/* Draws with `samples` for each source along each ray. */
bool peer_half_draw(peer_half *peer, int samples, char *message, size_t size);

#endif
