/*
 * ew-render: renders a scene file to a picture.
 */
#include "command_line.h"
#include "context.h"
#include "image.h"
#include "message.h"
#include "render.h"
#include "scene_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_BAD_INPUT = 2 };

static const char help[] =
    "Usage: ew-render SCENE.json [-o PICTURE] [--luminance FILE.pfm] [option]...\n"
    "Renders a scene of energy waves and opaque shapes, without a window.\n"
    "\n"
    "  -o, --output FILE       the picture: .png (8 bit, sRGB), .hdr or .pfm (linear floats); - writes PNG to\n"
    "                          standard output\n"
    "      --luminance FILE    B, the energy's light before compositing: .pfm, one float a pixel\n"
    "      --size WxH          in pixels, up to 8192x8192 (default 640x360)\n"
    "      --integrator NAME   adaptive, or with its largest relative error as in adaptive:1e-2,\n"
    "                          adaptive:1e-3 (default), adaptive:1e-4; or simpson:N, N divisions\n"
    "      --resolution NAME   adaptive: integrate fewer pixels where the light is smooth (default); or full: every one\n"
    "      --backend NAME      " BACKEND_HELP "\n"
    "  -h, --help              print this help\n"
    "      --version           print the version\n"
    "\n"
    "docs/scene-format.md describes scene files.\n"
    "Prints the GL it used, to standard error if the picture goes to standard output. Exit status: 0, or 2 with one line\n"
    "of what to mend on standard error.\n";

typedef struct command_line {
    const char *scene;
    const char *output;    /* NULL for none */
    const char *luminance; /* NULL for none */
    render_settings settings;
    context_backend backend;
} command_line;

static bool is_standard_output(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

/* Checks what concerns more than one option. */
static bool check_options(const command_line *options, char *message, size_t size)
{
    if (!options->scene)
        message_write(message, size, "SCENE.json: is missing; name the scene file to render");
    else if (!options->output && !options->luminance)
        message_write(message, size, "%s: no output is requested; add -o picture.png", options->scene);
    else if (options->output && !is_standard_output(options->output) && image_format_of(options->output) == IMAGE_UNKNOWN)
        message_write(message, size, "%s: has an unknown format; let its name end in .png, .hdr or .pfm", options->output);
    else if (options->luminance && image_format_of(options->luminance) != IMAGE_PFM)
        message_write(message, size, "%s: a luminance is written as .pfm; let its name end in .pfm", options->luminance);
    else if (options->output && options->luminance && strcmp(options->output, options->luminance) == 0)
        message_write(message, size, "%s: is the name of both the picture and the luminance; change one of them",
                      options->output);
    else
        return true;
    return false;
}

static bool read_picture_size(const char *text, void *target)
{
    render_settings *settings = target;
    return read_size(text, &settings->width, &settings->height);
}

/* Returns false with a message, or with an empty one where the options asked for a text that has been printed. */
static bool read_options(int argc, char **argv, command_line *options, char *message, size_t size)
{
    const command_option table[] = {
        {"output", 'o', read_text, &options->output, NULL},
        {"luminance", 0, read_text, &options->luminance, NULL},
        {"size", 0, read_picture_size, &options->settings, SIZE_REMEDY},
        {"integrator", 0, read_integrator, &options->settings, INTEGRATOR_REMEDY},
        {"resolution", 0, read_resolution, &options->settings.resolution, RESOLUTION_REMEDY},
        {"backend", 0, read_backend, &options->backend, BACKEND_REMEDY},
    };
    const command_program program = {"ew-render", help, table, sizeof table / sizeof *table};
    return command_line_read(&argc, argv, &program, message, size) &&
           command_line_read_scene(argc, argv, "render", &options->scene, message, size) &&
           check_options(options, message, size);
}

/* Draws the scene, and prints the GL that did. */
static bool render(const command_line *options, const demo_scene *scene, float *color, float *luminance, char *message,
                   size_t size)
{
    gl_context *context = context_create(options->backend, message, size);
    if (!context) return false;
    char reason[300];
    fprintf(is_standard_output(options->output) ? stderr : stdout, "%s\n", context_description(context));
    bool ok = render_scene(context, scene, &options->settings, color, luminance, reason, sizeof reason);
    if (!ok) message_write(message, size, "%s: %s", options->scene, reason);
    context_destroy(context);
    return ok;
}

static bool write_picture(const char *path, const image_pixels *picture, char *message, size_t size)
{
    return is_standard_output(path) ? image_print_png(picture, message, size) : image_write(path, picture, message, size);
}

static bool render_to_files(const command_line *options, char *message, size_t size)
{
    demo_scene scene;
    if (!scene_load(options->scene, &scene, message, size)) return false;
    const render_settings *settings = &options->settings;
    size_t pixels = (size_t)settings->width * (size_t)settings->height;
    float *color = options->output ? malloc(pixels * 4 * sizeof *color) : NULL;
    float *luminance = options->luminance ? malloc(pixels * sizeof *luminance) : NULL;
    bool ok = false;
    if ((options->output && !color) || (options->luminance && !luminance)) {
        message_write(message, size, "--size: the picture does not fit into memory; ask for a smaller one");
    } else if (render(options, &scene, color, luminance, message, size)) {
        image_pixels picture = {.width = settings->width, .height = settings->height, .channels = 4, .pixels = color};
        image_pixels light = {.width = settings->width, .height = settings->height, .channels = 1, .pixels = luminance};
        ok = (!color || write_picture(options->output, &picture, message, size)) &&
             (!luminance || image_write(options->luminance, &light, message, size));
    }
    free(color);
    free(luminance);
    scene_free(&scene);
    return ok;
}

int main(int argc, char **argv)
{
    command_line options = {.settings = {640, 360, EW_INTEGRATOR_ADAPTIVE, EW_QUALITY_ERROR_1E_3, 200, EW_RESOLUTION_ADAPTIVE},
                            .backend = CONTEXT_AUTO};
    char message[600];
    if (read_options(argc, argv, &options, message, sizeof message) && render_to_files(&options, message, sizeof message))
        return EXIT_SUCCESS;
    if (message[0] == '\0') return EXIT_SUCCESS;
    fprintf(stderr, "ew-render: %s\n", message);
    return EXIT_BAD_INPUT;
}
