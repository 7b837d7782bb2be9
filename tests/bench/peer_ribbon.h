/*
 * Ribbons, as games draw beams and trails: a strip along each source that turns to the eye, with half discs at its ends and
 * mitred corners, painted with the glow across a beam (peer_profile.h) and faded at the opaque depth. Left out: as for
 * billboards; and where a source bends more sharply than its reach, the strip folds and counts twice.
 */
#ifndef PEER_RIBBON_H
#define PEER_RIBBON_H

#include "peer_mesh.h"

extern const mesh_style peer_ribbon_style;

#endif
