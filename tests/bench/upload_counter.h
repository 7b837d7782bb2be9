/*
 * A loader that stands between an effect and a context, and counts the bytes that the effect hands to GL's buffers and
 * textures.
 */
#ifndef UPLOAD_COUNTER_H
#define UPLOAD_COUNTER_H

#include "context.h"

/* For ew_effect_desc: `user` is the context. All effects that are loaded so are counted together. */
ew_gl_function upload_counter_get_proc_address(void *user, const char *name);

/* The bytes since the last call. Texels are taken for 16 bytes if they have four components, and else for 4. */
size_t upload_counter_take(void);

#endif
