/*
 * Sources as lines to put billboards or ribbons on, in the view's space.
 */
#ifndef PEER_OUTLINE_H
#define PEER_OUTLINE_H

#include "source_kinds.h"

/* A place on a source. */
typedef struct outline_place {
    float position[3];
    float tangent[3]; /* unit; of a point, across the view */
    double speed;     /* how much the length grows with u */
    double weight;
} outline_place;

typedef struct outline {
    const source_kind *kind;
    const void *source;
    const double *view; /* the matrix, as in ew_frame_desc */
    source_light light; /* with its core, brightness and sharpness made explicit */
    size_t spans;       /* between corners, of equal shares of u */
    bool is_point;
    bool is_closed;
    double length;
} outline;

/* `epsilon` is the core of sources that have none of their own. */
outline outline_of(const source_kind *kind, const void *source, double epsilon, const double view[16]);

/* The place at u in [0, 1]. */
outline_place outline_at(const outline *shape, double u);

/* How many equal parts of u each span is divided into, so that the source has at least `count`. */
size_t outline_parts(const outline *shape, int count);

#endif
