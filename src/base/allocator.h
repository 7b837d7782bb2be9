/* Where the library's memory comes from. */
#ifndef EW_ALLOCATOR_H
#define EW_ALLOCATOR_H

#include "energywave.h"

/* malloc and free. */
extern const ew_allocator ew_default_allocator;

#endif
