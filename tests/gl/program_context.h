/* The contexts in which test programs run. */
#ifndef TEST_PROGRAM_CONTEXT_H
#define TEST_PROGRAM_CONTEXT_H

#include "api.h"

/* Describes the kind of context called `name`: gl33, gl45, gl45_compatibility, es30, es31, es32, osmesa33 or
 * osmesa45_compatibility. False, with a line on stderr, if there is none. */
bool describe_context(const char *name, context_desc *desc);

/* Opens a debug context of that description, makes it current, loads `gl` and watches debug output. NULL, with a line on
 * stderr, if there is none. */
gl_context *open_described_context(const context_desc *desc);

/* The same for the kind called `name`. Shares objects with `share`, which may be NULL. */
gl_context *open_context(const char *name, gl_context *share);

/* No context is current afterwards. */
void close_context(gl_context *context);

/* To be the last test of a program: GL had nothing to say about the others. */
void gl_has_nothing_to_say(void **state);

#endif
