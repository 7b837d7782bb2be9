/* One-line texts of errors: see message.h. */
#include "message.h"

#include <stdarg.h>
#include <stdio.h>

void message_write(char *message, size_t size, const char *format, ...)
{
    if (size == 0) return;
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(message, size, format, arguments);
    va_end(arguments);
    if (length < 0) message[0] = '\0';
    for (char *c = message; *c; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f) *c = '?';
}
