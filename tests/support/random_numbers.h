/*
 * Random numbers that are the same in every run: SplitMix64 (Steele, Lea, Flood: "Fast Splittable Pseudorandom Number
 * Generators", 2014).
 */
#ifndef RANDOM_NUMBERS_H
#define RANDOM_NUMBERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

static inline uint64_t random_bits(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* In [0, 1). */
static inline double random_unit(uint64_t *state)
{
    return (double)(random_bits(state) >> 11) * 0x1p-53;
}

/* In [0, count). */
static inline size_t random_index(uint64_t *state, size_t count)
{
    return (size_t)(random_unit(state) * (double)count);
}

/* In [low, high). */
static inline double random_between(uint64_t *state, double low, double high)
{
    return low + random_unit(state) * (high - low);
}

static inline bool random_chance(uint64_t *state, double probability)
{
    return random_unit(state) < probability;
}

#endif
