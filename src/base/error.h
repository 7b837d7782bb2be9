/* Filling an ew_error: the one way in which the library says that something went wrong. */
#ifndef EW_ERROR_H
#define EW_ERROR_H

#include "energywave.h"

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
/* Writes `code` and the text to `error` (which may be NULL) and returns `code`. */
ew_result
ew_fail(ew_error *error, ew_result code, const char *format, ...);

#endif
