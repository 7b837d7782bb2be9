/*
 * The texts of errors. Each is one line, even if the name or the content of a file brings control characters into it.
 */
#ifndef MESSAGE_H
#define MESSAGE_H

#include "printf_format.h"

#include <stddef.h>

/* Writes a text as snprintf does, and replaces control characters by '?'. */
PRINTF_FORMAT(3, 4) void message_write(char *message, size_t size, const char *format, ...);

#endif
