/*
 * The parts of a path, whose fields it is the sum of: pieces, straight or quadratic, and joints, which count negatively.
 */
#ifndef PATH_PARTS_H
#define PATH_PARTS_H

#include "source_kind.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct path_piece {
    ew_curve arc; /* on [0, 1] */
    const ew_path *path;
    double first_u, last_u; /* the path's parameter at its ends */
} path_piece;

typedef struct path_joint {
    ew_point point;
    double weight;
} path_joint;

/* Begins as zero, and may be made again and again. */
typedef struct path_parts {
    path_piece *pieces;
    size_t piece_count;
    path_joint *joints;
    size_t joint_count;
    size_t capacity; /* of either */
} path_parts;

/* Of the same kind as any source, for the integrand. */
extern const source_kind path_piece_kind;

/* Each cubic piece becomes the fewest equal parts that are quadratic within 3e-4 of `core`.
 * Returns false where memory is exhausted. */
bool path_parts_make(path_parts *parts, const ew_path *path, double core);
void path_parts_free(path_parts *parts);

/* The spans between control points of a path, each of which has an equal share of its parameter. */
size_t path_span_count(const ew_path *path);

/* The cubic Bezier control points of a span; of a kind that is straight or quadratic, raised to that. */
void path_span(const ew_path *path, size_t span, double cubic[4][3]);

#endif
