/* Hostile changes to descriptors: see spoil_desc.h. */
#include "spoil_desc.h"
#include "random_numbers.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static double hostile_number(uint64_t *random)
{
    static const double numbers[] = {
        NAN,     -NAN,        INFINITY, -INFINITY, 0,    -0.0,  5e-324, -5e-324, DBL_MIN,     DBL_MAX, -DBL_MAX,
        FLT_MIN, 1e-45,       FLT_MAX,  -FLT_MAX,  1e39, 1e-39, 1e18,   -1e18,   1e154,       1e-154,  1e308,
        1e-300,  4294967296., 65504,    65505,     1e12, 1e6,   1e-6,   1e-12,   DBL_EPSILON, -1,      2,
    };
    return numbers[random_index(random, COUNT(numbers))];
}

static double any_number(uint64_t *random)
{
    if (random_chance(random, 0.1)) return hostile_number(random);
    return random_power_of_ten(random, -20, 20) * (random_chance(random, 0.5) ? 1 : -1);
}

enum { MAX_RUNS = 1 + SOURCE_KIND_COUNT * MAX_KIND * MAX_SOURCE_RUNS };

static size_t source_runs(random_desc *desc, number_run runs[MAX_RUNS])
{
    size_t count = 0;
    runs[count++] = (number_run){&desc->sources.epsilon, 1};
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        for (size_t i = 0; i < source_count(kind, &desc->sources); i++) {
            void *source = (char *)desc->lists[k] + i * kind->size;
            if (kind->numbers)
                count += kind->numbers(source, runs + count);
            else
                runs[count++] = (number_run){source, kind->size / sizeof(double)};
        }
    }
    return count;
}

static size_t frame_runs(random_desc *desc, number_run runs[MAX_RUNS])
{
    ew_frame_desc *frame = &desc->frame;
    runs[0] = (number_run){frame->view, 16};
    runs[1] = (number_run){frame->projection, 16};
    runs[2] = (number_run){&frame->interval_start, 1};
    runs[3] = (number_run){&frame->interval_end, 1};
    runs[4] = (number_run){&frame->decay_alpha, 1};
    runs[5] = (number_run){&frame->decay_beta, 1};
    runs[6] = (number_run){&frame->core_pixels, 1};
    runs[7] = (number_run){&frame->exposure, 1};
    runs[8] = (number_run){&frame->light_gain, 1};
    runs[9] = (number_run){&frame->light_reach, 1};
    runs[10] = (number_run){&frame->shadow_thickness, 1};
    runs[11] = (number_run){&frame->fog.extinction, 1};
    runs[12] = (number_run){frame->fog.up, 3};
    runs[13] = (number_run){&frame->fog.base, 1};
    runs[14] = (number_run){&frame->fog.scale, 1};
    runs[15] = (number_run){desc->media[0].center, 3};
    runs[16] = (number_run){desc->media[0].half_axes[0], 9};
    runs[17] = (number_run){&desc->media[0].extinction, 1};
    runs[18] = (number_run){&desc->media[0].albedo, 1};
    runs[19] = (number_run){desc->media[0].ambient, 3};
    return 20;
}

static void spoil_one(const number_run *runs, size_t count, uint64_t *random)
{
    size_t run = random_index(random, count);
    if (runs[run].count > 0) runs[run].first[random_index(random, runs[run].count)] = hostile_number(random);
}

static void spoil_all(const number_run *runs, size_t count, uint64_t *random)
{
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < runs[i].count; j++)
            runs[i].first[j] = any_number(random);
}

void spoil_source_number(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_one(runs, source_runs(desc, runs), random);
}

void spoil_frame_number(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_one(runs, frame_runs(desc, runs), random);
}

void spoil_all_source_numbers(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_all(runs, source_runs(desc, runs), random);
}

void spoil_all_frame_numbers(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_all(runs, frame_runs(desc, runs), random);
}

static void spoil_weights(random_desc *desc, bool missing, size_t missing_count, size_t count, uint64_t *random)
{
    ew_curve *curve = (ew_curve *)desc->lists[KIND_CURVE] + random_index(random, desc->sources.curve_count);
    curve->weights = missing ? NULL : desc->weights[KIND_CURVE][0];
    curve->weight_count = missing ? missing_count : random_chance(random, 0.5) ? count : 0;
}

static void spoil_points(random_desc *desc, size_t count, uint64_t *random)
{
    ew_path *path = (ew_path *)desc->lists[KIND_PATH] + random_index(random, desc->sources.path_count);
    switch (random_index(random, 4)) {
    case 0:
        path->points = NULL;
        break;
    case 1:
        path->point_count = count;
        break;
    case 2:
        path->point_count = random_index(random, 2);
        break;
    default:
        path->is_closed = 2;
        break;
    }
}

void spoil_lists(random_desc *desc, uint64_t *random)
{
    static const size_t too_many[] = {100000, SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / sizeof(ew_curve) + 1};
    size_t count = too_many[random_index(random, COUNT(too_many))];
    bool missing = random_chance(random, 0.5);
    size_t missing_count = 1 + random_index(random, 3);
    if (desc->sources.path_count > 0 && random_chance(random, 0.3)) {
        spoil_points(desc, count, random);
        return;
    }
    size_t list = random_index(random, SOURCE_KIND_COUNT + (desc->sources.curve_count > 0));
    if (list == SOURCE_KIND_COUNT) {
        spoil_weights(desc, missing, missing_count, count, random);
        return;
    }
    if (missing) set_source_list(source_kinds[list], &desc->sources, NULL);
    set_source_count(source_kinds[list], &desc->sources, missing ? missing_count : count);
}

void spoil_frame_integer(random_desc *desc, uint64_t *random)
{
    static const int integers[] = {-1, 99, INT_MAX, INT_MIN, 255, 0x7fc00000};
    static const size_t fields[] = {
        offsetof(ew_frame_desc, clip_depth),   offsetof(ew_frame_desc, integrator),        offsetof(ew_frame_desc, quality),
        offsetof(ew_frame_desc, output),       offsetof(ew_frame_desc, simpson_divisions), offsetof(ew_frame_desc, viewport_x),
        offsetof(ew_frame_desc, viewport_y),   offsetof(ew_frame_desc, viewport_width),    offsetof(ew_frame_desc, encoding),
        offsetof(ew_frame_desc, depth_source), offsetof(ew_frame_desc, viewport_height),
    };
    int integer = integers[random_index(random, COUNT(integers))];
    _Static_assert(sizeof(ew_output) == sizeof integer, "an enumeration is copied as an int");
    memcpy((char *)&desc->frame + fields[random_index(random, COUNT(fields))], &integer, sizeof integer);
}
