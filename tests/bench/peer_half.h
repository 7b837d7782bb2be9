/*
 * Marching at half the resolution, as engines draw fog: jittered (peer_noise.glsl), with depth-aware upsampling
 * (peer_half_upsample.glsl). A wider filter leaves less noise, takes longer, and blurs the cores, so that the errors are
 * larger. Engines filter over frames as well, which is left out: light that moves smears.
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
