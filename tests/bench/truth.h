/*
 * What is right: the luminance of some of a picture's pixels in double precision, and how far a picture is from it.
 */
#ifndef TRUTH_H
#define TRUTH_H

#include "scene_file.h"

#include <stdbool.h>
#include <stddef.h>

/* A pixel counts as dark where its luminance is below this share of the largest; errors are relative to no less than that. */
#define TRUTH_DARK 1e-3

typedef struct truth_pixel {
    int x;
    int y; /* from the bottom */
    double luminance;
    bool reliable; /* the reference vouches for the luminance */
} truth_pixel;

typedef struct bench_truth {
    truth_pixel *pixels;
    size_t count;
    size_t unreliable_count;
    double largest; /* of the reliable luminances */
} bench_truth;

/* Chooses `count` pixels of a picture, or all of them if it has fewer, always the same ones, and computes their luminance with
 * all the machine's cores. Half of the pixels lie where the sources do, most of them within a few pixels: that is where the
 * light is, and the error. `depth` is the opaque scene's depth buffer, rows from the bottom, or NULL for none. On failure
 * returns false, with a message: "place: what to mend". Otherwise at least one pixel is reliable. */
bool truth_compute(const ew_scene *scene, int width, int height, const float *depth, size_t count, bench_truth *truth,
                   char *message, size_t size);

void truth_free(bench_truth *truth);

/* The errors of a picture's luminance (rows from the bottom) at the reliable pixels, each relative to the greater of the truth
 * and TRUTH_DARK of the largest truth: the largest error, and the one that 99 % do not exceed. What is no number counts as
 * infinitely wrong. Returns false where memory is exhausted. */
bool truth_errors(const bench_truth *truth, const float *luminance, int width, double *largest, double *percentile_99);

#endif
