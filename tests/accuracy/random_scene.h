/*
 * Scenes made up at random, as the text of scene files: of every kind of source, shape, size, core, interval and decay that the
 * library is held to.
 */
#ifndef RANDOM_SCENE_H
#define RANDOM_SCENE_H

#include "source_kinds.h"

#include <stdint.h>

/* Seeds from this one on are of scenes of the world integral; from twice of it on, of the papers' in fog; from three times of
 * it on, of the world's in fog; and from four and five times of it on, of the two among media, some of them in fog. */
#define RANDOM_WORLD_SEED 1000000000000u

/* What a scene consists of, in either integral: a single source of one of the kinds, in their order, or a combination. */
enum {
    RANDOM_SCENE_COMBINATION_COUNT = 4,
    RANDOM_PAPERS_KIND_COUNT = SOURCE_KIND_COUNT + RANDOM_SCENE_COMBINATION_COUNT,
    RANDOM_SCENE_KIND_COUNT = 2 * RANDOM_PAPERS_KIND_COUNT,
};

const char *random_scene_kind_name(int scene_kind);
/* -1 if there is no such kind. */
int random_scene_kind_find(const char *name);

/* The kind of the scene of a seed. */
int random_scene_kind_of(uint64_t seed);

/* The scene of a seed, always the same, to be freed by the caller; NULL where memory is exhausted.
 *
 * The camera looks from the distance D, from 1e-3 to 1e5, at a place on the first source, or near it; what it sees there is
 * from 1e-4 D high (but at least 20 epsilons) to 3 D. epsilon is from 1e-6 D to 1e-1 D: in a single precision's world it is a
 * length relative to the scene that can be small or large, not an absolute one. Sources are from 3e-3 D to 5 D long, the
 * interval's end / start from 1.2 to 1e4, beta from 0.05 to 4, and all of it up to 1e5 D from the world's origin. Every second
 * scene has an opaque plane or box before, in or behind the core. One eye in twenty is within a core.
 *
 * In the world integral, sources have cores from 1e-6 D to 1e-1 D of their own or epsilon, reaches from 1.01 cores to 10 D, and
 * some of them sharpness; the far plane may be in the midst of the light.
 *
 * Fog has 1e-6 to 1e3 optical depths from the eye to the place, most of it 0.01 to 10. Half of it changes with height, in any
 * direction, by a factor of e in 1e-2 D to 10 D.
 *
 * Media are one to six bodies of 1e-2 D to 3 D around the place or the eye, overlapping or not, of as many optical depths. */
char *random_scene_text(uint64_t seed);

#endif
