/* Filling an ew_error: the one way in which the library says that something went wrong. */
#ifndef EW_ERROR_H
#define EW_ERROR_H

#include "base/printf_format.h"
#include "energywave.h"

/* Writes `code` and the text to `error` (which may be NULL) and returns `code`. */
EW_PRINTF(3, 4) ew_result ew_fail(ew_error *error, ew_result code, const char *format, ...);

#endif
