/* What the unit tests share: cmocka, and checks of numbers and of errors that say what they found. */
#ifndef CHECK_H
#define CHECK_H

#include "energywave.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#define check_close(actual, expected, tolerance) check_close_at(#actual, actual, expected, tolerance, __FILE__, __LINE__)

static inline void check_close_at(const char *what, double actual, double expected, double tolerance, const char *file,
                                  int line)
{
    if (fabs(actual - expected) <= tolerance) return;
    print_error("%s is %.17g instead of %.17g, off by %g where %g is allowed\n", what, actual, expected,
                fabs(actual - expected), tolerance);
    _fail(file, line);
}

#define check_refused(result, error, code, field) check_refused_at(result, error, code, field, __FILE__, __LINE__)

/* The call returned `expected`, and the error holds it with one line that names `field`. */
static inline void check_refused_at(ew_result result, const ew_error *error, ew_result expected, const char *field,
                                    const char *file, int line)
{
    if (result == expected && error->code == expected && strstr(error->text, field) && !strchr(error->text, '\n')) return;
    print_error("expected code %d and \"%s\" named, got %d and %d: %s\n", (int)expected, field, (int)result, (int)error->code,
                error->text);
    _fail(file, line);
}

#endif
