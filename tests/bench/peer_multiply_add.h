/*
 * The rasteriser's arithmetic limit, beside which times can be seen.
 */
#ifndef PEER_MULTIPLY_ADD_H
#define PEER_MULTIPLY_ADD_H

#include "context.h"

/* How many multiply-adds in single precision fragment shaders do in a millisecond, at the most that was seen. 0 with a message
 * on failure. */
double multiply_adds_a_millisecond(gl_context *context, char *message, size_t size);

#endif
