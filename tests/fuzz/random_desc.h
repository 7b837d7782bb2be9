/*
 * Random descriptors for the library: valid ones, ordinary and extreme, and hostile changes to them. The same number gives the
 * same descriptors.
 */
#ifndef RANDOM_DESC_H
#define RANDOM_DESC_H

#include "energywave.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum target_depth { NO_DEPTH, DEPTH_TEXTURE, DEPTH_MULTISAMPLE, DEPTH_FRAMEBUFFER } target_depth;

/* What decides about the shader, which takes long to compile: so there are few of them. */
typedef struct shader_mix {
    size_t points, lines, tori, curves;
    bool weighted;
    ew_integrator integrator;
    ew_output output;
    target_depth depth;
    bool dither;
    ew_encoding encoding;
} shader_mix;

enum { MAX_KIND = 8, MAX_WEIGHTS = 6 };

/* A frame and sources, with their arrays; not to be copied, since they point into themselves. */
typedef struct random_desc {
    ew_frame_desc frame;
    ew_sources_desc sources;
    ew_point points[MAX_KIND];
    ew_line lines[MAX_KIND];
    ew_torus tori[MAX_KIND];
    ew_curve curves[MAX_KIND];
    double weights[MAX_KIND][MAX_WEIGHTS];
} random_desc;

/* The ordinary are what a host would ask for, at a scale of 1. The extreme go to the ends of the ranges that energywave.h
 * promises, and degenerate: sources at the eye, at the interval's ends, coincident control points, rings of radius 0. The
 * library may refuse them, where a combination goes too far. Neither names a target or a depth. */
void random_desc_make(random_desc *desc, const shader_mix *mix, bool extreme, int width, int height, uint64_t *random);

/* One number, the one of them that `random` picks, becomes a hostile one: not a number, infinite, denormal, huge ... */
void spoil_source_number(random_desc *desc, uint64_t *random);
void spoil_frame_number(random_desc *desc, uint64_t *random);

/* All of them become random ones of any size, some hostile. */
void spoil_all_source_numbers(random_desc *desc, uint64_t *random);
void spoil_all_frame_numbers(random_desc *desc, uint64_t *random);

/* A list without its array, an array without its list, or more than fits: always to be refused. */
void spoil_lists(random_desc *desc, uint64_t *random);

/* An enumeration, the divisions or the viewport out of range. */
void spoil_frame_integer(random_desc *desc, uint64_t *random);

#endif
