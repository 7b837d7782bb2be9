/*
 * The truth about the pixels of random scenes, and with it their errors.
 */
#ifndef RANDOM_TRUTH_H
#define RANDOM_TRUTH_H

#include "random_picture.h"

/* Completes pictures that have been drawn, on as many threads as there are processors. Returns false where memory is
 * exhausted. */
bool random_truths_compute(random_picture *pictures, size_t count);

#endif
