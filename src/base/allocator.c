/* The allocator of hosts that bring none. */
#include "base/allocator.h"

#include <stdlib.h>

static void *allocate(void *user, size_t size)
{
    (void)user;
    return malloc(size);
}

static void deallocate(void *user, void *memory)
{
    (void)user;
    free(memory);
}

const ew_allocator ew_default_allocator = {allocate, deallocate, NULL};
