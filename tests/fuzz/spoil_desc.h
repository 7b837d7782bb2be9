/*
 * Hostile changes to random descriptors.
 */
#ifndef SPOIL_DESC_H
#define SPOIL_DESC_H

#include "random_desc.h"

/* One number, which `random` picks, becomes a hostile one: not a number, infinite, denormal, huge ... */
void spoil_source_number(random_desc *desc, uint64_t *random);
void spoil_frame_number(random_desc *desc, uint64_t *random);

/* All of them become random ones of any size, some hostile. */
void spoil_all_source_numbers(random_desc *desc, uint64_t *random);
void spoil_all_frame_numbers(random_desc *desc, uint64_t *random);

/* A list without its array, an array without its list, or more than fits: always to be refused. */
void spoil_lists(random_desc *desc, uint64_t *random);

/* An enumeration, the divisions or the viewport out of range. */
void spoil_frame_integer(random_desc *desc, uint64_t *random);

#endif
