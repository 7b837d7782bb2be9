/* Shader permutations: what a shader must know, as the bits of a key. Only what a frame needs is compiled. */
#ifndef EW_PERMUTATION_H
#define EW_PERMUTATION_H

#include "model/kinds.h"

#include <stdbool.h>
#include <stdint.h>

typedef uint64_t ew_key;

/* The lowest bits of a key. */
enum {
    EW_PERMUTATION_WEIGHTS = 1 << 0,
    EW_PERMUTATION_DEPTH = 1 << 1,
    EW_PERMUTATION_SIMPSON = 1 << 2,
    EW_PERMUTATION_LUMINANCE = 1 << 3,
    EW_PERMUTATION_EVALUATIONS = 1 << 4,
    EW_PERMUTATION_DEPTH_MULTISAMPLE = 1 << 5, /* with EW_PERMUTATION_DEPTH */
    EW_PERMUTATION_DITHER = 1 << 6,
    EW_PERMUTATION_DITHER_SRGB = 1 << 7, /* with EW_PERMUTATION_DITHER */
    EW_PERMUTATION_WORLD = 1 << 8,       /* with EW_PERMUTATION_REACH */
    EW_PERMUTATION_REACH = 1 << 9,
    EW_PERMUTATION_CORE_PIXELS = 1 << 10,
    EW_PERMUTATION_SHARPNESS = 1 << 11,
    EW_PERMUTATION_SOFT = 1 << 12,
    EW_PERMUTATION_POLYLINES = 1 << 13,
    EW_PERMUTATION_BENDS = 1 << 14,
    EW_PERMUTATION_LISTS = 1 << 15, /* with EW_PERMUTATION_REACH and no exact counts */
    EW_PERMUTATION_SOURCE_TEXTURE = 1 << 16,
    EW_PERMUTATION_IRRADIANCE = 1 << 17, /* the light on surfaces */
    EW_PERMUTATION_SHADOWS = 1 << 18,    /* with EW_PERMUTATION_IRRADIANCE, of the pass of surfaces */
    EW_PERMUTATION_NORMALS = 1 << 19,    /* likewise */
    EW_PERMUTATION_FOG = 1 << 20,
    EW_PERMUTATION_FOG_HEIGHT = 1 << 21, /* with EW_PERMUTATION_FOG */
    EW_PERMUTATION_MEDIA = 1 << 22,      /* likewise */
    EW_PERMUTATION_PART = 1 << 23,       /* the light of a part of the sources, with no exact counts */
    EW_PERMUTATION_SUMMED = 1 << 24,     /* no sources: their light has been summed up */
    EW_PERMUTATION_BEAMS = 1 << 25,
    EW_PERMUTATION_FLAG_COUNT = 26,
};

/* What becomes of the light. */
#define EW_PERMUTATION_OF_TARGET                                                                                               \
    ((ew_key)(EW_PERMUTATION_LUMINANCE | EW_PERMUTATION_DITHER | EW_PERMUTATION_DITHER_SRGB | EW_PERMUTATION_SOFT))

/* The forms of paths that the shader knows. */
#define EW_PERMUTATION_FORMS ((ew_key)(EW_PERMUTATION_BEAMS | EW_PERMUTATION_POLYLINES | EW_PERMUTATION_BENDS))

/* Above the flags stand the counts of sources by kind, each in a field of EW_PERMUTATION_COUNT_BITS: 0 and 1 stand for
 * themselves, and EW_ANY_COUNT for any. */
enum { EW_PERMUTATION_COUNT_BITS = 2 };

/* Where the shader reads the opaque scene's depth from. */
typedef enum ew_depth_kind { EW_DEPTH_KIND_NONE, EW_DEPTH_KIND_SINGLE, EW_DEPTH_KIND_MULTISAMPLE } ew_depth_kind;

/* The key of the shader that draws `mix` as `frame` says, without depth. */
ew_key ew_permutation_of(const ew_mix *mix, const ew_frame_desc *frame);

/* The key of the shader that draws the frame's media themselves, likewise. */
ew_key ew_permutation_of_media(const ew_frame_desc *frame);

/* What a pixel of the mix costs, in points without a reach. */
double ew_mix_cost(const ew_mix *mix);

/* The key with that depth. */
ew_key ew_permutation_with_depth(ew_key key, ew_depth_kind depth);

/* The key with lists by tile, if it knows reaches; then any count of a kind that it knows will do. */
ew_key ew_permutation_with_lists(ew_key key);

/* The key without the forms of paths that there are none of. */
ew_key ew_permutation_with_forms(ew_key key, const bool has_list[EW_LIST_COUNT]);

/* The lists of a kind that `key` knows, from `first` to the one before `last`; and of all kinds. */
typedef struct ew_list_range {
    int first, last;
} ew_list_range;

ew_list_range ew_permutation_lists_of(ew_key key, int kind);
ew_list_range ew_permutation_lists(ew_key key);

/* Whether `key` knows sources of a part; and the key of the shader for these alone. */
bool ew_permutation_has_part(ew_key key, ew_part part);
ew_key ew_permutation_of_part(ew_key key, ew_part part);

/* The key of the shader that composites what the parts of `key` have summed up. */
ew_key ew_permutation_summed(ew_key key);

/* Whether the light of the parts of `key` can be summed up before it is composited; and whether it is to be, because one shader
 * for all of them would take more than a second to compile. */
bool ew_permutation_can_be_split(ew_key key);
bool ew_permutation_is_split(ew_key key);

/* The key with that many sources of a kind, none before. */
ew_key ew_permutation_with_count(ew_key key, int kind, size_t count);

/* The count of a kind, or EW_ANY_COUNT. */
unsigned ew_permutation_count(ew_key key, int kind);

/* Whether the shader of `key` draws all that the one of `other` does, if slower. */
bool ew_permutation_covers(ew_key key, ew_key other);

#endif
