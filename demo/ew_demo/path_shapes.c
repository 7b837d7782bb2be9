/* The shapes of the court's paths: see path_shapes.h. */
#include "path_shapes.h"
#include "vector.h"

#include <stdint.h>

/* A number in [-1, 1] for each pair, by the mixing function of MurmurHash3. */
static double random_of(unsigned seed, unsigned key)
{
    uint32_t h = seed * 0x9e3779b9u + key * 0x85ebca6bu;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return (h ^ h >> 16) / 2147483647.5 - 1;
}

double path_noise(path_clock clock, int rate, unsigned seed)
{
    unsigned key_count = (unsigned)lround(rate * clock.period);
    double at = clock.seconds * rate, key = floor(at), t = at - key;
    unsigned first = (unsigned)key % key_count, next = (first + 1) % key_count;
    return random_of(seed, first) + t * t * (3 - 2 * t) * (random_of(seed, next) - random_of(seed, first));
}

/* How far the bolt strays in one direction at `u` of its way: octaves of noise that is linear along the way, so that the bolt
 * has corners. Finer octaves move faster. */
static double stray(double u, path_clock clock, unsigned seed)
{
    double sum = 0;
    for (unsigned octave = 0; octave < 4; octave++) {
        unsigned kinks = 3u << octave;
        int rate = 3 + 2 * (int)octave;
        double at = u * kinks, key = floor(at);
        unsigned knot = 64 * seed + 16 * octave + (unsigned)key % kinks;
        double a = path_noise(clock, rate, knot), b = path_noise(clock, rate, knot + 1);
        sum += (a + (at - key) * (b - a)) / (1u << octave);
    }
    return sum;
}

void path_make_bolt(const double start[3], const double end[3], double spread, path_clock clock, unsigned seed,
                    double (*points)[3], size_t count)
{
    double way[3], along[3], across[2][3];
    vector_subtract(end, start, way);
    vector_normalize(way, along);
    vector_across(along, across[0], across[1]);
    for (size_t i = 0; i < count; i++) {
        double u = (double)i / (double)(count - 1), size = spread * vector_length(way) * sqrt(4 * u * (1 - u));
        vector_add_scaled(start, u, way, points[i]);
        for (unsigned j = 0; j < 2; j++)
            vector_add_scaled(points[i], size * stray(u, clock, 2 * seed + j), across[j], points[i]);
    }
}

void path_make_helix(const path_helix *helix, double (*points)[3], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        double u = (double)i / (double)(count - 1), angle = helix->start_angle + 2 * M_PI * helix->turns * u;
        double radius = helix->radii[0] + u * (helix->radii[1] - helix->radii[0]);
        double arm[3] = {radius * cos(angle), u * helix->height, radius * sin(angle)};
        vector_add_scaled(helix->base, 1, arm, points[i]);
    }
}

void path_make_arc(const path_arc *arc, double (*points)[3], size_t count)
{
    double axis[3], start[3], side[3];
    vector_normalize(arc->axis, axis);
    vector_add_scaled(arc->start, -vector_dot(arc->start, axis), axis, start);
    vector_normalize(start, start);
    vector_cross(axis, start, side);
    for (size_t i = 0; i < count; i++) {
        double angle = arc->angle * (double)i / (double)(count - 1);
        vector_add_scaled(arc->center, arc->radius * cos(angle), start, points[i]);
        vector_add_scaled(points[i], arc->radius * sin(angle), side, points[i]);
    }
}
