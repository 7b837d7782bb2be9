/* Allocations that are freed together: see memory_chain.h. */
#include "memory_chain.h"

#include <stdlib.h>

struct memory_chain {
    memory_chain *next;
    void *memory;
};

void *memory_chain_allocate(memory_chain **chain, size_t count, size_t element_size)
{
    memory_chain *link = malloc(sizeof *link);
    void *memory = link ? calloc(count, element_size) : NULL;
    if (!memory) {
        free(link);
        return NULL;
    }
    *link = (memory_chain){*chain, memory};
    *chain = link;
    return memory;
}

void memory_chain_free(memory_chain **chain)
{
    while (*chain) {
        memory_chain *link = *chain;
        *chain = link->next;
        free(link->memory);
        free(link);
    }
}
