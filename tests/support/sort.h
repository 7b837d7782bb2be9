/*
 * Numbers in order.
 */
#ifndef SORT_H
#define SORT_H

#include <stdlib.h>

static inline int sort_compare(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

/* From the least to the largest. */
static inline void sort_numbers(double *numbers, size_t count)
{
    qsort(numbers, count, sizeof *numbers, sort_compare);
}

#endif
