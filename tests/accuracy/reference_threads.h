/*
 * The reference on several threads.
 */
#ifndef REFERENCE_THREADS_H
#define REFERENCE_THREADS_H

#include "reference.h"

#include <stdbool.h>
#include <stddef.h>

/* Does one of several tasks; returns false to give up. Called on several threads at once. */
typedef bool reference_task(void *user, reference_workspace *workspace, size_t index);

/* Calls `task` for each index below `count`, on up to `threads` threads, this one among them, in no order. Returns false if a
 * task gave up, or where memory is exhausted. */
bool reference_threads_run(reference_task *task, void *user, size_t count, int threads);

#endif
