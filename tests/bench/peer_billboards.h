/*
 * Soft billboards, as games draw glows: sprites along each source that turn to the eye and add up, with a falloff that is
 * fitted to the glow across a beam (peer_profile.h), faded at the opaque depth. An orb has one. Left out: what stands closer to
 * a source's bends than to its nearest point, the end of the light at the opaque scene along each ray, and the eye within the
 * glow.
 */
#ifndef PEER_BILLBOARDS_H
#define PEER_BILLBOARDS_H

#include "peer_mesh.h"

extern const mesh_style peer_billboards_style;

#endif
