/* Paths as chains of quadratic pieces in world space. Everything here takes the core's radius that is in force: the path's own,
 * or the epsilon of the sources. */
#ifndef EW_PATH_H
#define EW_PATH_H

#include "model/kinds.h"
#include "model/spline.h"

/* A piece begins where the one before it ends. Pieces too short to be seen are left out; then `domain` has a gap there. */
typedef struct ew_path_piece {
    ew_quadratic curve;
    /* The path's parameter t at both ends, in [0, 1]. In between it grows evenly with the curve's own parameter. */
    double domain[2];
    /* The curve is its chord, from end to end, though t need not be even along it: polynomial[2] may be along the chord. */
    bool is_straight;
    /* The start is a joint of the path, at t = domain[0]: so are all starts but that of an open path. */
    bool starts_at_joint;
} ew_path_piece;

/* Checks points and weights. */
ew_result ew_check_path(const ew_path *path, const ew_source_name *name, ew_error *error);

/* Counts the pieces of a checked path, 1 to EW_MAX_PATH_PIECES; refuses a path that has more. */
ew_result ew_count_path_pieces(const ew_path *path, double core, const ew_source_name *name, size_t *count, ew_error *error);

/* Fills as many pieces as ew_count_path_pieces counts. A path that is a single point has one piece, of no length. */
void ew_make_path_pieces(const ew_path *path, double core, ew_path_piece *pieces);

#endif
