/* Files that are written: see output_file.h. */
#include "output_file.h"
#include "message.h"

#include <errno.h>
#include <string.h>

bool output_file_close(FILE *file, const char *path, char *message, size_t size)
{
    bool written = file && !ferror(file);
    if (file) written = fclose(file) == 0 && written;
    if (!written) message_write(message, size, "%s: cannot be written (%s)", path, strerror(errno));
    return written;
}
