/*
 * Peers that sample the field along each pixel's ray: uniform marching and equiangular sampling. They draw what the library
 * draws, with its rays, its uniform blocks, its lists of sources by tile and its sum over the sources, and peer_*.glsl in place
 * of its integrators. The lists are made once and no state is saved, both in the peers' favour.
 */
#ifndef PEER_SAMPLED_H
#define PEER_SAMPLED_H

#include "context.h"
#include "integrator.h"

typedef struct peer_sampled peer_sampled;

/* NULL with a message on failure. */
peer_sampled *peer_sampled_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame,
                                  char *message, size_t size);
void peer_sampled_destroy(peer_sampled *peer);

/* `family` is FAMILY_MARCHING or FAMILY_EQUIANGULAR. */
bool peer_sampled_draw(peer_sampled *peer, integrator_family family, int samples, ew_output output, char *message, size_t size);

#endif
