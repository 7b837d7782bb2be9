/* The times that the demo shows are those of a GPU. Of a rasteriser in software it shows none: it draws when it likes, so the
 * times of a split picture's halves were swapped. */
#include "context.h"
#include "gpu_timer.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

static void a_rasteriser_in_software_has_no_times(void **unused)
{
    (void)unused;
    char message[400];
    gl_context *context = context_create(CONTEXT_AUTO, message, sizeof message);
    if (!context) fail_msg("%s", message);
    const gl_functions *gl = context_gl(context);
    const bool is_software = strstr((const char *)gl->GetString(GL_RENDERER), "llvmpipe") != NULL;
    gpu_timer timer;
    gpu_timer_create(gl, &timer);
    for (int frame = 0; frame < 2 * GPU_TIMER_QUERIES; frame++) {
        gpu_timer_begin(gl, &timer);
        gpu_timer_end(gl, &timer);
        gl->Finish();
    }
    if (is_software) assert_true(timer.milliseconds < 0);
    gpu_timer_destroy(gl, &timer);
    context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_rasteriser_in_software_has_no_times)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
