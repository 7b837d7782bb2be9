/*
 * The shapes of a scene's parts as straight pieces.
 */
#ifndef PART_SHAPE_H
#define PART_SHAPE_H

#include "scene_part.h"

/* Takes a straight piece of a part, from a to b. */
typedef void part_piece(void *user, const double a[3], const double b[3]);

/* Gives the part's shape as straight pieces, near enough to it for a drawing or the pointer. A point is one piece of no length.
 * A line, which has no end, ends far away. An opaque shape or a medium is its edges, or circles on it; a plane is a square
 * around its point. */
void part_shape(const demo_scene *scene, scene_part part, part_piece *take, void *user);

#endif
