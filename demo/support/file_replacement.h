/*
 * A file that takes the place of another one only when it is complete.
 */
#ifndef FILE_REPLACEMENT_H
#define FILE_REPLACEMENT_H

#include <stdbool.h>
#include <stdio.h>

typedef struct file_replacement {
    FILE *file; /* to write to; NULL after a failure */
    const char *path;
    char *temporary; /* its name until it is complete, beside `path` */
} file_replacement;

/* Creates the file under the first name beside `path` that is free. On failure returns false and sets errno. */
bool file_replacement_begin(file_replacement *replacement, const char *path);

/* Closes the file. If `is_complete` and it could be written, it gets its name; or else it is removed, and errno is kept.
 * Returns whether it got its name. May be called after a failed begin. */
bool file_replacement_end(file_replacement *replacement, bool is_complete);

#endif
