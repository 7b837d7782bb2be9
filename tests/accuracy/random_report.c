/* What was found about random scenes: see random_report.h. */
#include "random_report.h"
#include "random_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Errors beyond these are counted. */
#define LARGE_ERROR 1e-2
#define USUAL_ERROR 1e-3

typedef struct error_counts {
    size_t scenes, pixels, unreliable, bad, unusual, wrong;
    double largest;
} error_counts;

static void count_errors(const random_picture *picture, error_counts *counts)
{
    counts->scenes++;
    for (int i = 0; i < RANDOM_PIXEL_COUNT; i++) {
        const random_pixel *pixel = &picture->pixels[i];
        counts->pixels++;
        counts->unreliable += !pixel->reliable;
        counts->bad += !isfinite(pixel->error);
        counts->unusual += pixel->error > USUAL_ERROR;
        counts->wrong += pixel->error > LARGE_ERROR;
        counts->largest = fmax(counts->largest, pixel->error);
    }
}

static void print_counts(const char *name, const error_counts *counts)
{
    if (counts->scenes > 0)
        printf("%-20s %6zu %8zu %10.2e %8zu %7.3f %% %8zu %6zu %10zu\n", name, counts->scenes, counts->pixels, counts->largest,
               counts->unusual, 100.0 * (double)counts->unusual / (double)counts->pixels, counts->wrong, counts->bad,
               counts->unreliable);
}

/* The table of all kinds of scenes. */
static void print_kinds(const error_counts kinds[RANDOM_SCENE_KIND_COUNT], const error_counts *all)
{
    printf("%-20s %6s %8s %10s %8s %9s %8s %6s %10s\n", "kind", "scenes", "pixels", "largest", "> 1e-3", "", "> 1e-2", "bad",
           "unreliable");
    for (int kind = 0; kind < RANDOM_SCENE_KIND_COUNT; kind++)
        print_counts(random_scene_kind_name(kind), &kinds[kind]);
    print_counts("all", all);
}

static void print_worst(const random_picture *const *pictures, size_t count)
{
    if (count > 0)
        printf("\n%-14s %-20s %-10s %10s %13s %13s %11s\n", "seed", "kind", "pixel", "error", "luminance", "truth",
               "rounded ray");
    for (size_t i = 0; i < count; i++) {
        const random_pixel *pixel = pictures[i]->worst;
        char place[24];
        snprintf(place, sizeof place, "%d,%d", pixel->x, pixel->y);
        printf("%-14llu %-20s %-10s %10.2e %13.6g %13.6g %11.1e\n", (unsigned long long)pictures[i]->seed,
               random_scene_kind_name(pictures[i]->kind), place, pixel->error, (double)pixel->luminance, pixel->truth,
               pictures[i]->sensitivity);
    }
}

static bool is_bounded(const error_counts *counts, const random_bounds *bounds)
{
    return counts->largest <= bounds->largest && (double)counts->unusual <= bounds->unusual_share * (double)counts->pixels;
}

/* Prints what was found, of pictures that are sorted; returns whether all is well. */
static bool report(const random_picture *const *pictures, size_t count, size_t worst, const random_bounds *bounds)
{
    error_counts all = {0}, kinds[RANDOM_SCENE_KIND_COUNT] = {{0}};
    for (size_t i = 0; i < count; i++) {
        count_errors(pictures[i], &all);
        count_errors(pictures[i], &kinds[pictures[i]->kind]);
    }
    print_kinds(kinds, &all);
    print_worst(pictures, worst < count ? worst : count);
    bool bounded = true;
    for (int kind = 0; bounds && kind < RANDOM_SCENE_KIND_COUNT; kind++)
        bounded = bounded && is_bounded(&kinds[kind], bounds);
    return all.bad == 0 && all.unreliable * 100 <= all.pixels && bounded;
}

static int compare_pictures(const void *a, const void *b)
{
    const random_picture *first = *(const random_picture *const *)a, *second = *(const random_picture *const *)b;
    double first_error = first->worst->error, second_error = second->worst->error;
    if (first_error != second_error) return first_error < second_error ? 1 : -1;
    return (first->seed > second->seed) - (first->seed < second->seed);
}

bool random_report_print(const random_picture *pictures, size_t count, size_t worst, const random_bounds *bounds, bool *well)
{
    const random_picture **order = malloc((count + 1) * sizeof *order);
    if (!order) return false;
    for (size_t i = 0; i < count; i++)
        order[i] = &pictures[i];
    qsort(order, count, sizeof *order, compare_pictures);
    *well = report(order, count, worst, bounds);
    free(order);
    return true;
}
