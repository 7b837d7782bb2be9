/*
 * Random descriptors for the library, ordinary and extreme. The same number gives the same descriptors.
 */
#ifndef RANDOM_DESC_H
#define RANDOM_DESC_H

#include "energywave.h"
#include "source_kinds.h"

#include <stdbool.h>
#include <stdint.h>

/* What sources have beside a coefficient, and which integral is over them. */
typedef enum source_field { FIELD_PLAIN, FIELD_REACH, FIELD_WORLD } source_field;

typedef enum target_depth { NO_DEPTH, DEPTH_TEXTURE, DEPTH_MULTISAMPLE, DEPTH_FRAMEBUFFER } target_depth;

/* What decides about the shader, which takes long to compile: so there are few of them. */
typedef struct shader_mix {
    size_t count_of_each;             /* how many sources there are of each kind, */
    size_t counts[SOURCE_KIND_COUNT]; /* and how many more of some */
    bool weighted;
    source_field field;
    bool sharp; /* with a reach */
    bool has_core_pixels;
    bool lights_surfaces;
    bool has_shadows;
    bool has_fog;
    bool has_media;
    ew_integrator integrator;
    ew_output output;
    target_depth depth;
    bool dither;
    ew_encoding encoding;
} shader_mix;

size_t shader_mix_count(const shader_mix *mix, int kind);

/* The most sources of a kind. */
enum { MAX_KIND = 8 };

/* A frame and sources, with their arrays; not to be copied, since they point into themselves. */
typedef struct random_desc {
    ew_frame_desc frame;
    ew_sources_desc sources;
    void *lists[SOURCE_KIND_COUNT]; /* room for MAX_KIND sources of each kind; `sources` points there */
    double weights[SOURCE_KIND_COUNT][MAX_KIND][MAX_RANDOM_WEIGHTS];
    double points[SOURCE_KIND_COUNT][MAX_KIND][MAX_RANDOM_POINTS][3];
    ew_medium media[EW_MAX_MEDIA];
} random_desc;

/* The ordinary are what a host would ask for, at a scale of 1. The extreme go to the ends of the ranges that energywave.h
 * promises, and degenerate: sources at the eye, at the interval's ends, coincident control points, tori of radius 0. The
 * library may refuse them, where a combination goes too far. Neither names a target or a depth. Returns false where memory is
 * exhausted; `desc` is to be freed in any case. */
bool random_desc_make(random_desc *desc, const shader_mix *mix, bool extreme, int width, int height, uint64_t *random);
void random_desc_free(random_desc *desc);

#endif
