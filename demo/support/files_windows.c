/* Files on Windows: see files.h. */
#include "files.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <string.h>
#include <sys/stat.h>

#include <windows.h>

FILE *file_create(const char *path)
{
    int descriptor = _open(path, _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY, _S_IREAD | _S_IWRITE);
    if (descriptor < 0) return NULL;
    FILE *file = _fdopen(descriptor, "wb");
    if (!file) _close(descriptor);
    return file;
}

bool file_replace(const char *from, const char *to)
{
    if (MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING)) return true;
    errno = EACCES;
    return false;
}

void file_take_permissions(const char *path, const char *other)
{
    (void)path;
    (void)other;
}

char *file_behind_links(const char *path)
{
    return _strdup(path);
}

bool file_exists(const char *path)
{
    return _access(path, 0) == 0;
}

bool file_is_terminal(FILE *file)
{
    return _isatty(_fileno(file));
}

void file_print_bytes(void)
{
    _setmode(_fileno(stdout), _O_BINARY);
}

file_state file_look_at(const char *path)
{
    WIN32_FILE_ATTRIBUTE_DATA now = {0};
    if (!GetFileAttributesExA(path, GetFileExInfoStandard, &now)) return (file_state){0};
    /* Time is in steps of 100 nanoseconds. */
    const long long steps = (long long)now.ftLastWriteTime.dwHighDateTime << 32 | now.ftLastWriteTime.dwLowDateTime;
    return (file_state){.size = (long long)now.nFileSizeHigh << 32 | now.nFileSizeLow,
                        .seconds = steps / 10000000,
                        .nanoseconds = steps % 10000000 * 100};
}
