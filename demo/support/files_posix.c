/* Files on Unix: see files.h. */
#include "files.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

FILE *file_create(const char *path)
{
    int descriptor = open(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (descriptor < 0) return NULL;
    FILE *file = fdopen(descriptor, "wb");
    if (!file) close(descriptor);
    return file;
}

bool file_replace(const char *from, const char *to)
{
    return rename(from, to) == 0;
}

void file_take_permissions(const char *path, const char *other)
{
    struct stat state;
    if (stat(other, &state) == 0) chmod(path, state.st_mode & 0777);
}

char *file_behind_links(const char *path)
{
    char *behind = realpath(path, NULL);
    return behind ? behind : strdup(path);
}

bool file_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

bool file_is_terminal(FILE *file)
{
    return isatty(fileno(file));
}

void file_print_bytes(void)
{
}

file_state file_look_at(const char *path)
{
    struct stat now = {0};
    stat(path, &now);
    return (file_state){.size = now.st_size,
                        .seconds = now.st_mtim.tv_sec,
                        .nanoseconds = now.st_mtim.tv_nsec,
                        .number = (unsigned long long)now.st_ino};
}
