/*
 * Allocations that are freed together.
 */
#ifndef MEMORY_CHAIN_H
#define MEMORY_CHAIN_H

#include <stddef.h>

typedef struct memory_chain memory_chain;

/* Allocates zeroed memory and adds it to *chain, which begins as NULL. Returns NULL where memory is exhausted. */
void *memory_chain_allocate(memory_chain **chain, size_t count, size_t element_size);

/* Frees everything in the chain, and sets it to NULL. */
void memory_chain_free(memory_chain **chain);

#endif
