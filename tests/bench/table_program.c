/* Benchmarks that write a page of tables: see table_program.h. */
#include "table_program.h"
#include "command_line.h"
#include "message.h"

#include <stdlib.h>
#include <unistd.h>

enum { EXIT_BAD_INPUT = 2 };

/* Of the program's name and purpose, and twice the page's topic. */
#define HELP_FORMAT                                                                                                            \
    "Usage: %s [option]...\n"                                                                                                  \
    "%s\n"                                                                                                                     \
    "\n"                                                                                                                       \
    "      --size WxH       of the pictures, in pixels (default 640x360)\n"                                                    \
    "      --report FOLDER  writes FOLDER/%s.md\n"                                                                             \
    "      --name NAME      makes that FOLDER/%s-NAME.md\n"                                                                    \
    "      --backend NAME   egl, osmesa or auto (default): EGL or else OSMesa\n"                                               \
    "  -h, --help           print this help\n"                                                                                 \
    "\n"                                                                                                                       \
    "Prints tables. Exit status: 0, or 2 with one line of what to mend on standard error.\n"

static bool read_picture_size(const char *text, void *target)
{
    table_settings *settings = target;
    return read_size(text, &settings->width, &settings->height);
}

static bool read_options(const table_program *program, int argc, char **argv, table_settings *settings, char *message,
                         size_t size)
{
    const command_option table[] = {
        {"size", 0, read_picture_size, settings, SIZE_REMEDY},
        {"report", 0, read_text, &settings->report, NULL},
        {"name", 0, read_text, &settings->name, NULL},
        {"backend", 0, read_backend, &settings->backend, BACKEND_REMEDY},
    };
    char help[1000];
    snprintf(help, sizeof help, HELP_FORMAT, program->name, program->purpose, program->topic, program->topic);
    const command_program described = {program->name, help, table, sizeof table / sizeof *table};
    if (!command_line_read(&argc, argv, &described, message, size)) return false;
    if (argc == 1) return true;
    message_write(message, size, "%s: is no option; see --help", argv[1]);
    return false;
}

FILE *table_page_open(const table_program *program, gl_context *context, const table_settings *settings, bench_machine *machine,
                      char path[4096], char *message, size_t size)
{
    page_paths paths;
    if (!machine_describe(context, machine, message, size) ||
        !page_make_folders(program->topic, settings->report, settings->name, &paths, message, size))
        return NULL;
    rmdir(paths.plots); /* there are none */
    snprintf(path, 4096, "%s", paths.page);
    FILE *file = fopen(path, "w");
    if (file)
        page_begin(file, program->title, program->name, machine);
    else
        message_write(message, size, "%s: cannot be written", path);
    return file;
}

static bool run(const table_program *program, const table_settings *settings, char *message, size_t size)
{
    gl_context *context = context_create(settings->backend, message, size);
    if (!context) return false;
    puts(context_description(context));
    bool ok = program->run(context, settings, message, size);
    context_destroy(context);
    return ok;
}

int table_program_main(const table_program *program, int argc, char **argv)
{
    table_settings settings = {.width = 640, .height = 360, .backend = CONTEXT_AUTO};
    char message[600];
    if (!read_options(program, argc, argv, &settings, message, sizeof message)) {
        if (message[0] == '\0') return EXIT_SUCCESS;
    } else if (run(program, &settings, message, sizeof message)) {
        return EXIT_SUCCESS;
    }
    fprintf(stderr, "%s: %s\n", program->name, message);
    return EXIT_BAD_INPUT;
}
