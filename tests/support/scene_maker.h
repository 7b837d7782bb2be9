/*
 * A random scene in the making: where it takes place, and the numbers and words that its sources are made of.
 */
#ifndef SCENE_MAKER_H
#define SCENE_MAKER_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct scene_maker {
    uint64_t random;
    FILE *file;      /* the scene file */
    bool is_world;   /* of the world integral */
    double distance; /* from the eye to `place` */
    double epsilon;
    double least_core; /* of the source that is being written, set by its kind */
    double eye[3];
    double place[3];   /* on the first source, and looked at */
    double forward[3]; /* from the eye to the place, unit */
} scene_maker;

double maker_between(scene_maker *maker, double low, double high);
/* From low to high, all magnitudes alike. */
double maker_magnitude(scene_maker *maker, double low, double high);
bool maker_chance(scene_maker *maker, double probability);
/* A unit vector, all directions alike. */
void maker_direction(scene_maker *maker, double result[3]);
/* A vector in the ball of the given radius. */
void maker_offset(scene_maker *maker, double radius, double result[3]);

/* How large a source is. */
double maker_source_extent(scene_maker *maker);
/* A place that a source goes through: for the first one the place that the eye looks at, for the others one around it. */
void maker_source_place(scene_maker *maker, bool first, double place[3]);

/* Writes "key": [x, y, z] and a comma. */
void maker_write_vector(scene_maker *maker, const char *key, const double vector[3]);
/* Writes "weights": from one to many, some of them 0, and a comma. On what is closed, the last is the first. */
void maker_write_weights(scene_maker *maker, bool is_closed);

#endif
