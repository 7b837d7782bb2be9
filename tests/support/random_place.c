/* Where random sources are: see random_place.h. */
#include "random_place.h"
#include "random_numbers.h"

#include <math.h>

double random_power_of_ten(uint64_t *random, double low, double high)
{
    return pow(10, random_between(random, low, high));
}

static void to_world(const random_place *place, const double view[3], double world[3])
{
    for (int i = 0; i < 3; i++)
        world[i] = place->eye[i] + place->axes[0][i] * view[0] + place->axes[1][i] * view[1] + place->axes[2][i] * view[2];
}

void random_position(const random_place *place, double world[3])
{
    uint64_t *random = place->random;
    bool extreme = place->extreme;
    double depth = random_between(random, place->start, place->end), view[3];
    double wide = extreme && random_chance(random, 0.1) ? random_power_of_ten(random, 0, 4) : 1;
    if (extreme && random_chance(random, 0.2)) depth = random_chance(random, 0.5) ? place->start : place->end;
    if (extreme && random_chance(random, 0.05)) depth = 0;
    for (int i = 0; i < 2; i++)
        view[i] = wide * (place->slope[i] * depth + place->size[i]) * random_between(random, -1, 1);
    if (extreme && random_chance(random, 0.2)) view[0] = view[1] = 0;
    view[2] = -depth;
    to_world(place, view, world);
}

void random_direction(const random_place *place, double world[3])
{
    double length = place->extreme ? random_power_of_ten(place->random, -300, 300) : 1;
    bool along_an_axis = place->extreme && random_chance(place->random, 0.3);
    size_t axis = random_index(place->random, 3);
    for (int i = 0; i < 3; i++)
        world[i] = length * (along_an_axis ? place->axes[axis][i] : random_between(place->random, -1, 1));
}

size_t random_weights(const random_place *place, double *weights)
{
    size_t count = 1 + random_index(place->random, MAX_RANDOM_WEIGHTS);
    for (size_t i = 0; i < MAX_RANDOM_WEIGHTS; i++)
        weights[i] = place->extreme ? random_power_of_ten(place->random, -9, 3) * (double)random_index(place->random, 3)
                                    : random_unit(place->random);
    return count;
}

void random_light(const random_place *place, double *coefficient, double color[3])
{
    *coefficient = place->extreme ? random_power_of_ten(place->random, -9, 9) : random_between(place->random, 0, 5);
    if (random_chance(place->random, 0.02)) *coefficient = 0;
    for (int i = 0; i < 3; i++)
        color[i] = place->extreme && random_chance(place->random, 0.1) ? 65504 : random_between(place->random, 0, 1);
}
