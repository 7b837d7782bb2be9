/*
 * What C leaves to the system about files. files_posix.c and files_windows.c implement it.
 */
#ifndef FILES_H
#define FILES_H

#include <stdbool.h>
#include <stdio.h>

/* Creates a file for writing bytes, with the permissions of any new file. Returns NULL and sets errno on failure, to EEXIST if
 * there is one of this name. */
FILE *file_create(const char *path);

/* Gives the file `from` the name `to`, in the place of any file there is. On failure sets errno and returns false. */
bool file_replace(const char *from, const char *to);

/* Gives the file the permissions of another one, if that is there and the system has such. */
void file_take_permissions(const char *path, const char *other);

/* Returns the path of the file that a link leads to, or a copy of a path that is no link. The caller frees it; NULL where
 * memory is exhausted. */
char *file_behind_links(const char *path);

bool file_exists(const char *path);

bool file_is_terminal(FILE *file);

/* Has bytes written to standard output as they are. */
void file_print_bytes(void);

/* What changes if a file is written or replaced; all 0 if there is none. */
typedef struct file_state {
    long long size;
    long long seconds;
    long long nanoseconds;
    unsigned long long number; /* of the file among others, where the system has such */
} file_state;

file_state file_look_at(const char *path);

#endif
