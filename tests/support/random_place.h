/*
 * Where random sources are and how large they may be, for descriptors that go straight to the library: ordinary ones, and
 * extreme ones at the ends of the ranges that energywave.h promises.
 */
#ifndef RANDOM_PLACE_H
#define RANDOM_PLACE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MAX_RANDOM_WEIGHTS = 6, MAX_RANDOM_POINTS = 10 };

typedef struct random_place {
    uint64_t *random;
    bool extreme;
    double axes[3][3]; /* of the view, in the world */
    double eye[3];
    double start, end;        /* of the interval */
    double slope[2], size[2]; /* what is seen, from the view's axis: slope * depth + size */
} random_place;

/* 10 to a power in [low, high). */
double random_power_of_ten(uint64_t *random, double low, double high);

/* A position that is most often seen; some of the extreme ones are at the eye, on its axis, or where the interval ends. */
void random_position(const random_place *place, double world[3]);

/* Not a unit vector; some of the extreme ones are along an axis of the view. */
void random_direction(const random_place *place, double world[3]);

/* Weights, MAX_RANDOM_WEIGHTS at the most. Returns how many. */
size_t random_weights(const random_place *place, double *weights);

/* A coefficient and a color. */
void random_light(const random_place *place, double *coefficient, double color[3]);

#endif
