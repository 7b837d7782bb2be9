/*
 * What the pages that the benchmarks write have in common.
 */
#ifndef PAGE_H
#define PAGE_H

#include "results.h"

#include <stdio.h>

/* Formats a number to two or three digits. The text is valid until the eighth call after this one. */
const char *page_number(double value);

/* Where a page and its plots go. */
typedef struct page_paths {
    char base[128]; /* of both, without folder */
    char page[4096];
    char plots[4096]; /* a folder */
} page_paths;

/* Makes the folders for FOLDER/TOPIC.md, or FOLDER/TOPIC-NAME.md where `name` is not NULL, and its plots. On failure returns
 * false, with a message. */
bool page_make_folders(const char *topic, const char *folder, const char *name, page_paths *paths, char *message, size_t size);

/* Writes who wrote the page, and by which machine; `program` is the writer. */
void page_begin(FILE *file, const char *title, const char *program, const bench_machine *machine);

#endif
