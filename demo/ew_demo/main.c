/*
 * ew-demo: moving energy waves, in a window or as pictures.
 */
#include "message.h"
#include "offscreen.h"
#include "options.h"
#ifdef EW_HAVE_GLFW
#include "window.h"
#endif

#include <stdio.h>
#include <stdlib.h>

enum { EXIT_BAD_INPUT = 2 };

static bool run(const demo_options *options, char *message, size_t size)
{
    if (options->offscreen) return offscreen_run(options, message, size);
#ifdef EW_HAVE_GLFW
    return window_run(options, message, size);
#else
    message_write(message, size,
                  "built without GLFW, and so without a window; add --offscreen -o frames/%%05d.png, or install "
                  "GLFW (on Debian libglfw3-dev) and build again");
    return false;
#endif
}

int main(int argc, char **argv)
{
    demo_options options = {.last_frame = 299,
                            .frames_per_second = 30,
                            .settings = {1280, 720, EW_INTEGRATOR_ADAPTIVE, EW_QUALITY_ERROR_1E_3, 200, EW_RESOLUTION_ADAPTIVE},
                            .right = {.integrator = EW_INTEGRATOR_SIMPSON, .simpson_divisions = 128},
                            .samples_per_axis = 2,
                            .backend = CONTEXT_AUTO};
    char message[600];
    if (options_read(argc, argv, &options, message, sizeof message) && run(&options, message, sizeof message))
        return EXIT_SUCCESS;
    if (message[0] == '\0') return EXIT_SUCCESS;
    fprintf(stderr, "ew-demo: %s\n", message);
    return EXIT_BAD_INPUT;
}
