/*
 * The shapes of sources as straight pieces.
 */
#ifndef SOURCE_SHAPE_H
#define SOURCE_SHAPE_H

#include "source_part.h"

/* Takes a straight piece of a source, from a to b. */
typedef void source_piece(void *user, const double a[3], const double b[3]);

/* Gives the source's shape as straight pieces, near enough to it for a drawing or the pointer. A point is one piece of no
 * length. A line, which has no end, ends far away. */
void source_shape(const ew_sources_desc *sources, source_part part, source_piece *take, void *user);

#endif
