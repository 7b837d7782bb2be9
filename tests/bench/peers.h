/*
 * The integrators that are not the library's, each drawing onto the same target:
 *
 *   - those that sample the field along each pixel's ray (peer_sampled.h), and the same at half resolution (peer_half.h)
 *   - what games have instead of a field: billboards (peer_billboards.h) and ribbons (peer_ribbon.h)
 *   - the bare pass, which writes a constant
 */
#ifndef PEERS_H
#define PEERS_H

#include "context.h"
#include "integrator.h"

typedef struct bench_peers bench_peers;

/* Prepares drawing `sources`, which must outlive the peers, as `frame` says, its integrator and output aside. NULL with a
 * message on failure. */
bench_peers *peers_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                          size_t size);

void peers_destroy(bench_peers *peers);

/* Draws; `output` is EW_OUTPUT_LUMINANCE or, of those that count evaluations, EW_OUTPUT_EVALUATIONS. The first draw of an
 * integrator and output compiles its shaders and makes its meshes. */
bool peers_draw(bench_peers *peers, const bench_integrator *integrator, ew_output output, char *message, size_t size);

#endif
