/* The contexts in which test programs run. */
#ifndef TEST_PROGRAM_CONTEXT_H
#define TEST_PROGRAM_CONTEXT_H

#include "api.h"

/* A context of that description, or of the kind called `name` (see context.h), sharing objects with `share` or NULL. It becomes
 * current, `gl` is loaded, and debug output watched. NULL, with a line on stderr, if there is none. */
test_context *open_context(const char *name, test_context *share);
test_context *open_described_context(const test_context_desc *desc);

/* Leaves none current. */
void close_context(test_context *context);

/* A test that comes last: GL had nothing to say about those before it. */
void gl_has_nothing_to_say(void **state);

#endif
