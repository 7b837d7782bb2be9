/*
 * Files that are written and must not be lost without a word.
 */
#ifndef OUTPUT_FILE_H
#define OUTPUT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Closes a file; NULL is one that could not be opened. Returns false, with a message, unless all was written. */
bool output_file_close(FILE *file, const char *path, char *message, size_t size);

#endif
