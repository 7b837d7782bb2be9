/*
 * A source as the reference sees it, and what a kind of source answers about it: see source_kind.h.
 */
#ifndef REFERENCE_SOURCE_H
#define REFERENCE_SOURCE_H

struct source_kind;

typedef struct reference_source {
    const struct source_kind *kind;
    const void *desc;   /* the ew_point, ew_line, ... */
    double position[3]; /* relative to where the reference measures positions from */
    double axis[3];     /* unit, if the kind has one */
} reference_source;

typedef struct nearest_point {
    double distance;
    double offset[3]; /* from the nearest point to the point asked about */
    double t;         /* the parameter, if the source is a curve */
    int piece;        /* in [0, 8): changes wherever the nearest point leaps or meets an end */
} nearest_point;

typedef struct reference_weighting {
    double weight;  /* at a nearest point */
    double largest; /* of all weights of the source */
    int span;       /* the polynomial piece that the weight is on */
} reference_weighting;

#endif
