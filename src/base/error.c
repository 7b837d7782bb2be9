/* Results as values: the table of texts, and the filling of an ew_error. */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>

const char *ew_result_text(ew_result result)
{
    static const char *const texts[] = {
#define EW_RESULT_TEXT(name, text) [name] = text,
        EW_RESULTS(EW_RESULT_TEXT)
#undef EW_RESULT_TEXT
    };
    if ((size_t)result >= sizeof texts / sizeof texts[0]) return "unknown result";
    return texts[result];
}

ew_result ew_fail(ew_error *error, ew_result code, const char *format, ...)
{
    if (error) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(error->text, sizeof error->text, format, arguments);
        va_end(arguments);
        error->code = code;
    }
    return code;
}
