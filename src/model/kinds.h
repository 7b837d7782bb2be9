/*
 * The kinds of sources, one row each. Lists, capacity, the uniform block, shader permutations and error texts are all driven by
 * these rows. A kind's own file has its row and the functions in it.
 */
#ifndef EW_KINDS_H
#define EW_KINDS_H

#include "model/layout.h"
#include "model/limits.h"
#include "model/ray_space.h"

#include "energywave.h"

#include <stdbool.h>
#include <stddef.h>

/* A source in messages: "curves[2]". */
typedef struct ew_source_name {
    const char *list;
    size_t index;
} ew_source_name;

/* The members with which the structure of every kind ends. */
typedef struct ew_emission {
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} ew_emission;

/* A ball in the world around all of a source. */
typedef struct ew_ball {
    double center[3];
    double radius;  /* HUGE_VAL: the source is a line without an end, */
    double axis[3]; /* along this unit vector */
} ew_ball;

enum { EW_MAX_HULL_CORNERS = 8 };

/* A convex polygon around a source, or around a piece of one; of a source that has no end, a line. */
typedef struct ew_hull {
    double corners[EW_MAX_HULL_CORNERS][3]; /* in order, in the world */
    size_t corner_count;
    double direction[3]; /* unit, of a line through the only corner; else 0 */
} ew_hull;

/* A source's weights along its length, as the uniform block has them; pieces is 0 for a source without. */
typedef struct ew_weight_range {
    size_t first_piece;
    size_t piece_count;
    double mean; /* of the weights; 1 for a source without */
} ew_weight_range;

/* The host's weights of a source; none has a count of 0. */
typedef struct ew_weight_list {
    const double *values;
    size_t count;
} ew_weight_list;

/* The parts into which a frame's sources are divided where one shader for all of them would take long to compile. */
typedef enum ew_part {
    EW_PART_STRAIGHT, /* points, lines, beams */
    EW_PART_POLYLINES,
    EW_PART_BENDS, /* paths with bent pieces */
    EW_PART_TORI,
    EW_PART_CURVES,
    EW_PART_COUNT,
} ew_part;

/* The lists of a tile (see plan/tile_lists.h). Those of a part are neighbours, and so are those of a kind. */
typedef enum ew_list {
    EW_LIST_POINTS,
    EW_LIST_LINES,
    EW_LIST_BEAMS,
    EW_LIST_POLYLINES,
    EW_LIST_BENDS,
    EW_LIST_TORI,
    EW_LIST_CURVES,
} ew_list;
_Static_assert(EW_LIST_CURVES + 1 == EW_LIST_COUNT, "GLSL counts other lists");

static inline bool ew_is_list_of_paths(ew_list list)
{
    return list >= EW_LIST_BEAMS && list <= EW_LIST_BENDS;
}

_Static_assert(EW_STRAIGHT_UNITS == sizeof(struct ew_straight_block) / sizeof(ew_vec4), "a straight piece takes other units");
_Static_assert(EW_BENT_UNITS == sizeof(struct ew_bent_block) / sizeof(ew_vec4), "a bent piece takes other units");

/* The most files of GLSL that one kind has. */
enum { EW_KIND_MAX_FILES = 8 };

/* The pieces of a source, as the uniform block has them. */
typedef struct ew_piece_range {
    const void *pieces;
    size_t piece_count;
    size_t first_unit; /* in the uniform block's data */
    size_t piece_units;
    ew_ball ball;
} ew_piece_range;

/* What a row says of sources that are chains of pieces. Pieces are made once, in world space, and packed for each frame. */
typedef struct ew_chain_kind {
    size_t piece_size;
    /* Counts the pieces of a source whose core has that radius, and the units (vec4) that each takes. */
    ew_result (*count)(const void *source, double core, const ew_source_name *name, size_t *count, ew_error *error);
    void (*make)(const void *source, double core, void *pieces);
    size_t (*piece_units)(const void *source, const void *pieces, size_t count);
    size_t (*most_piece_units)(const void *source);
    /* As `hull` of a kind, of one piece. */
    ew_hull (*hull)(const void *piece);
    const char *list_file;         /* of GLSL: reads a source by its place in the lists */
    const char *const *bend_files; /* of GLSL, before the kind's own, if the shader knows bent pieces; up to a NULL */
    const char *const *sampled_bend_files;
    /* Completes the source's block and packs its pieces into `units`. */
    ew_result (*pack)(const ew_source_name *name, const ew_ray_space *space, const void *pieces, const ew_piece_range *range,
                      void *block, ew_vec4 *units, ew_error *error);
} ew_chain_kind;

typedef struct ew_kind {
    const char *name;       /* "point": ew_point(i) and ew_point_block in GLSL */
    const char *upper_name; /* "POINT": EW_POINT_COUNT in GLSL */
    const char *list_name;  /* "points" */
    size_t size;            /* of ew_point */
    size_t emission_offset; /* of its ew_emission */
    size_t list_offset;     /* of its list in ew_sources_desc */
    size_t count_offset;    /* of the list's count there */
    size_t mix_offset;      /* of its count in ew_mix */
    size_t block_size;      /* of struct ew_point_block, a multiple of sizeof(ew_vec4) */
    size_t color_offset;    /* of the block's `color`, behind which stands `glow` */

    /* Checks what is the kind's own: shape and weights. */
    ew_result (*check)(const void *source, const ew_source_name *name, ew_error *error);
    /* About how many points' integrals one of its own takes, on a software rasteriser; of a chain, for two pieces. */
    int cost_in_points;
    /* The smallest ball that is easily found. */
    ew_ball (*bound)(const void *source);
    /* What the light's silhouette is found from. NULL for a chain, whose pieces have hulls. */
    ew_hull (*hull)(const void *source);
    /* NULL for a kind that has no weights. */
    ew_weight_list (*weights)(const void *source);
    /* Brings a checked source to ray space, in double precision until the last step, and fills all of its block but `color` and
     * `glow`. Refuses what is too far away or too large there. */
    ew_result (*pack)(const void *source, const ew_source_name *name, const ew_ray_space *space, const ew_weight_range *weights,
                      void *block, ew_error *error);
    const ew_chain_kind *chain; /* of a kind whose sources are chains of pieces; else NULL */
    ew_part part;               /* of a chain: of its beams */
    ew_list list;               /* of a chain: of its beams; behind it stand those of its polylines and of those with bends */

    /* The GLSL file of what all integrators need; NULL for a kind that has only one file. */
    const char *chord_file;
    /* GLSL files, in order: for the adaptive integrator, and for those that only sample the field. */
    const char *adaptive_files[EW_KIND_MAX_FILES];
    const char *sampling_files[EW_KIND_MAX_FILES];
    /* For the light on surfaces. */
    const char *irradiance_files[EW_KIND_MAX_FILES];
    const char *gloss_files[EW_KIND_MAX_FILES]; /* behind those */
} ew_kind;

/* The part of a row that the names of a kind make: EW_KIND_NAMES(point, POINT, points). */
#define EW_KIND_NAMES(kind, KIND, kinds)                                                                                       \
    .name = #kind, .upper_name = #KIND, .list_name = #kinds, .size = sizeof(ew_##kind),                                        \
    .emission_offset = offsetof(ew_##kind, coefficient), .list_offset = offsetof(ew_sources_desc, kinds),                      \
    .count_offset = offsetof(ew_sources_desc, kind##_count), .mix_offset = offsetof(ew_mix, kind##_count),                     \
    .block_size = sizeof(struct ew_##kind##_block), .color_offset = offsetof(struct ew_##kind##_block, color)

/* Holds what EW_KIND_NAMES relies on, and the limit of the kind in the public header. */
#define EW_CHECK_KIND(kind, kinds_limit)                                                                                       \
    _Static_assert(sizeof(ew_##kind) - offsetof(ew_##kind, coefficient) == sizeof(ew_emission),                                \
                   #kind " must end as ew_emission");                                                                          \
    _Static_assert(offsetof(struct ew_##kind##_block, color) == sizeof(struct ew_##kind##_block) - 2 * sizeof(ew_vec4) &&      \
                       offsetof(struct ew_##kind##_block, glow) == sizeof(struct ew_##kind##_block) - sizeof(ew_vec4),         \
                   #kind "'s block must end with color and glow");                                                             \
    _Static_assert(sizeof(struct ew_##kind##_block) % sizeof(ew_vec4) == 0, #kind " must consist of vec4");                    \
    _Static_assert((kinds_limit) == EW_MAX_SOURCE_UNITS / (sizeof(struct ew_##kind##_block) / sizeof(ew_vec4) - 1),            \
                   #kind " takes other units in the public header")

/* All rows, in the order in which the uniform block has the sources. */
extern const ew_kind *const ew_kinds[EW_KIND_COUNT];

/* The units (vec4) that a source of the kind takes, without weights. `has_glow`: the block's last member is there. */
static inline size_t ew_kind_units(const ew_kind *kind, bool has_glow)
{
    return kind->block_size / sizeof(ew_vec4) - (has_glow ? 0 : 1);
}

static inline const ew_emission *ew_source_emission(const ew_kind *kind, const void *source)
{
    return (const ew_emission *)((const char *)source + kind->emission_offset);
}

/* ---- For the rows: each refuses with a text that names the field ---- */

ew_result ew_check_vector(const ew_source_name *name, const char *field, const double v[3], ew_error *error);

/* Finite, and not zero. */
ew_result ew_check_direction(const ew_source_name *name, const char *field, const double v[3], ew_error *error);

ew_result ew_refuse_coordinates(const ew_source_name *name, ew_error *error);

/* Coordinates in ray space. */
static inline ew_result ew_check_coordinates(const ew_source_name *name, const double v[3], ew_error *error)
{
    bool is_near = fabs(v[0]) <= EW_MAX_COORDINATE && fabs(v[1]) <= EW_MAX_COORDINATE && fabs(v[2]) <= EW_MAX_COORDINATE;
    return is_near ? EW_OK : ew_refuse_coordinates(name, error);
}

#endif
