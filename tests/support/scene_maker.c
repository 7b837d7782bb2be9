/* A random scene in the making: see scene_maker.h. */
#include "scene_maker.h"
#include "random_numbers.h"
#include "vector.h"

double maker_between(scene_maker *maker, double low, double high)
{
    return random_between(&maker->random, low, high);
}

double maker_magnitude(scene_maker *maker, double low, double high)
{
    return low * pow(high / low, random_unit(&maker->random));
}

bool maker_chance(scene_maker *maker, double probability)
{
    return random_chance(&maker->random, probability);
}

void maker_direction(scene_maker *maker, double result[3])
{
    double z = maker_between(maker, -1, 1), angle = maker_between(maker, 0, 2 * M_PI), across = sqrt(1 - z * z);
    result[0] = across * cos(angle);
    result[1] = across * sin(angle);
    result[2] = z;
}

void maker_offset(scene_maker *maker, double radius, double result[3])
{
    double direction[3], zero[3] = {0, 0, 0};
    maker_direction(maker, direction);
    vector_add_scaled(zero, radius * cbrt(maker_between(maker, 0, 1)), direction, result);
}

double maker_source_extent(scene_maker *maker)
{
    return maker->distance * maker_magnitude(maker, 3e-3, 5);
}

void maker_source_place(scene_maker *maker, bool first, double place[3])
{
    double offset[3];
    maker_offset(maker, first ? 0 : maker_source_extent(maker), offset);
    vector_add_scaled(maker->place, 1, offset, place);
}

void maker_write_vector(scene_maker *maker, const char *key, const double vector[3])
{
    fprintf(maker->file, "\"%s\": [%.17g, %.17g, %.17g], ", key, vector[0], vector[1], vector[2]);
}

void maker_write_weights(scene_maker *maker, bool is_closed)
{
    static const int counts[] = {1, 2, 3, 4, 5, 7, 16, 64};
    int count = counts[random_index(&maker->random, sizeof counts / sizeof *counts)];
    fputs("\"weights\": [", maker->file);
    double first = 0;
    for (int i = 0; i < count; i++) {
        double weight = maker_chance(maker, 0.2) ? 0 : maker_between(maker, 0, 1);
        if (i == 0) first = weight;
        fprintf(maker->file, "%s%.3g", i ? ", " : "", is_closed && i == count - 1 ? first : weight);
    }
    fputs("], ", maker->file);
}
