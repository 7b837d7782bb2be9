/* Opening and closing contexts, and what GL said in between. */
#include "program_context.h"
#include "debug_output.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

test_context *open_described_context(const test_context_desc *desc)
{
    test_context *context = test_context_create(desc);
    if (context == NULL) return NULL;
    test_context_make_current(context);
    api_load(context);
    debug_output_watch();
    fprintf(stderr, "%s, %s\n", (const char *)gl.GetString(GL_RENDERER), (const char *)gl.GetString(GL_VERSION));
    return context;
}

test_context *open_context(const char *name, test_context *share)
{
    test_context_desc desc;
    if (!test_context_describe(name, &desc)) return NULL;
    desc.share = share;
    return open_described_context(&desc);
}

void close_context(test_context *context)
{
    test_context_make_current(NULL);
    test_context_destroy(context);
}

void gl_has_nothing_to_say(void **state)
{
    (void)state;
    assert_int_equal(debug_output_count(), 0);
}
