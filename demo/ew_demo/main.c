/*
 * ew-demo: energy waves that move, in a window or as pictures.
 */
#include "message.h"
#include "offscreen.h"
#include "options.h"

#include <stdio.h>
#include <stdlib.h>

enum { EXIT_BAD_INPUT = 2 };

static bool run(const demo_options *options, char *message, size_t size)
{
    if (options->offscreen) return offscreen_run(options, message, size);
    message_write(message, size, "this build has no window; add --offscreen");
    return false;
}

int main(int argc, char **argv)
{
    demo_options options = {.last_frame = 299,
                            .frames_per_second = 30,
                            .settings = {1280, 720, EW_INTEGRATOR_ADAPTIVE, EW_QUALITY_ERROR_1E_3, 200},
                            .samples_per_axis = 1,
                            .backend = CONTEXT_AUTO};
    char message[600];
    /* Mesa's EGL would add lines of its own to the one that says why there is no context. */
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    if (options_read(argc, argv, &options, message, sizeof message) && run(&options, message, sizeof message))
        return EXIT_SUCCESS;
    if (message[0] == '\0') return EXIT_SUCCESS;
    fprintf(stderr, "ew-demo: %s\n", message);
    return EXIT_BAD_INPUT;
}
