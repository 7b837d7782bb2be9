/* Replacing a file: see file_replacement.h. */
#include "file_replacement.h"
#include "files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const int largest_temporary = 9999;

bool file_replacement_begin(file_replacement *replacement, const char *path)
{
    size_t size = strlen(path) + sizeof ".9999.tmp";
    *replacement = (file_replacement){.path = path, .temporary = malloc(size)};
    if (!replacement->temporary) return false;
    errno = EEXIST;
    for (int number = 0; !replacement->file && number <= largest_temporary && errno == EEXIST; number++) {
        snprintf(replacement->temporary, size, "%s.%d.tmp", path, number);
        replacement->file = file_create(replacement->temporary);
    }
    return replacement->file != NULL;
}

bool file_replacement_end(file_replacement *replacement, bool is_complete)
{
    bool was_created = replacement->file != NULL, ok = is_complete && was_created;
    if (was_created) ok = fclose(replacement->file) == 0 && ok;
    ok = ok && file_replace(replacement->temporary, replacement->path);
    int reason = errno;
    if (was_created && !ok) remove(replacement->temporary);
    free(replacement->temporary);
    *replacement = (file_replacement){0};
    errno = reason;
    return ok;
}
