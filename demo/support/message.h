/*
 * The texts of errors: one line each, whatever bytes a file's name or content brought into them.
 */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <stddef.h>

/* Writes a text as snprintf does, with control characters (a newline in a file's name, say) made '?'. */
__attribute__((format(printf, 3, 4))) void message_write(char *message, size_t size, const char *format, ...);

#endif
