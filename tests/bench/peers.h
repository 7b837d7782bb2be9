/*
 * The integrators that are not the library's: uniform marching and equiangular sampling, and the bare pass that does nothing.
 * They draw what the library draws, with the library's rays, uniform blocks and sum over the sources, and peer_*.glsl in place
 * of its integrators. The uniform blocks of the sources are uploaded once and no state is saved, both in the peers' favour.
 */
#ifndef PEERS_H
#define PEERS_H

#include "context.h"
#include "integrator.h"

typedef struct bench_peers bench_peers;

/* Prepares drawing `sources` as `frame` says, its integrator and output aside. NULL with a message on failure. */
bench_peers *peers_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                          size_t size);

void peers_destroy(bench_peers *peers);

/* Draws; `output` is EW_OUTPUT_LUMINANCE or EW_OUTPUT_EVALUATIONS. The first draw of a family and output compiles a shader. */
bool peers_draw(bench_peers *peers, const bench_integrator *integrator, ew_output output, char *message, size_t size);

#endif
