/*
 * What the tests know of a kind of source. Each kind fills one row, in its own file in kinds/, and everything that handles
 * sources of any kind loops over the rows: see source_kinds.h.
 */
#ifndef SOURCE_KIND_H
#define SOURCE_KIND_H

#include "energywave.h"
#include "random_place.h"
#include "reference_source.h"
#include "scene_maker.h"

#include <stdbool.h>
#include <stddef.h>

enum { MAX_SOURCE_DIRECTIONS = 2, MAX_SOURCE_RUNS = 5 };

/* The members with which a source of any kind ends. */
typedef struct source_light {
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} source_light;

/* What a camera sees of a scene. */
typedef struct source_view {
    double middle[3]; /* the place in the middle of the interval, on the view's axis */
    double length;    /* of the interval */
} source_view;

/* Numbers of a source that lie one after the other. */
typedef struct number_run {
    double *first;
    size_t count;
} number_run;

typedef struct source_kind {
    const char *name;      /* of a single source */
    const char *list_name; /* of the list in scene files */
    size_t size;           /* of a source, in bytes */

    /* Where ew_sources_desc has the list and its count, and ew_mix the count. */
    size_t list_offset;
    size_t count_offset;
    size_t mix_count_offset;

    /* Where a source has its position, which moves and turns with the world, and its directions, which only turn. */
    size_t position_offset;
    size_t direction_offsets[MAX_SOURCE_DIRECTIONS];
    size_t direction_count;
    size_t light_offset;
    /* Where a source has a list of points instead, each of which moves and turns with the world. */
    bool has_points;
    size_t points_offset;
    size_t point_count_offset;

    /* Its light has a closed form, so the shader evaluates the distance once. */
    bool has_closed_form;

    /* ---- The reference ---- */

    /* The first direction, brought to unit length, is the axis of the reference's source. */
    bool has_axis;
    /* Shifted along its axis, the source stays the same. */
    bool is_endless;
    /* How far from its position the source extends at the most. NULL: not at all, but along its axis if it is endless. */
    double (*extent)(const void *source);
    nearest_point (*nearest)(const reference_source *source, const double point[3]);
    /* The weight at a nearest point. NULL: the source has no weights. */
    reference_weighting (*weigh)(const reference_source *source, const nearest_point *nearest);
    /* Points of the source that are spread over it. NULL: its position alone. */
    void (*seed)(const reference_source *source, int number, double seed[3]);
    int seed_count;
    /* Where the distance has a kink on the ray through the origin along `direction`, which the nearest point does not tell.
     * Returns false if nowhere. NULL: never. */
    bool (*kink)(const reference_source *source, const double direction[3], double *x);

    /* ---- Random scenes ---- */

    /* Finds the place at u in [0, 1] of the source's bright core, or of the part that a camera sees. */
    void (*place)(const void *source, const source_view *view, double u, double place[3]);
    /* How often a random scene of the papers' integral has one source of this kind and no other, relative to the other kinds
     * of scenes; and one of the world integral, which has a name of its own. */
    double scene_share;
    double world_scene_share;
    const char *world_scene_name;
    /* Writes what a scene file has for a random source, but for its coefficient. `first`: it goes through the place that the
     * camera looks at. */
    void (*write)(scene_maker *maker, bool first, bool weighted);

    /* ---- Hostile input ---- */

    /* Fills a source that is all zero. `weights` has room for MAX_RANDOM_WEIGHTS numbers; NULL: it shall have none. `points`
     * has room for MAX_RANDOM_POINTS. */
    void (*make)(const random_place *place, void *source, double *weights, double (*points)[3]);
    /* Lists the numbers of a source and returns how many runs they are. NULL: the source consists of doubles alone. */
    size_t (*numbers)(void *source, number_run runs[MAX_SOURCE_RUNS]);
} source_kind;

/* The part of a row that says where things are: of the kind with sources of `type`, whose count in ew_sources_desc and ew_mix
 * has the same name. */
#define SOURCE_KIND_LAYOUT(type, list, count, position)                                                                        \
    .size = sizeof(type), .list_offset = offsetof(ew_sources_desc, list), .count_offset = offsetof(ew_sources_desc, count),    \
    .mix_count_offset = offsetof(ew_mix, count), .position_offset = offsetof(type, position),                                  \
    .light_offset = offsetof(type, coefficient)

#endif
