/* What the pages have in common: see page.h. */
#include "page.h"
#include "message.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

const char *page_number(double value)
{
    static char texts[8][32];
    static int next;
    char *text = texts[next++ % 8];
    double magnitude = fabs(value);
    if (value == 0 || !isfinite(value))
        snprintf(text, sizeof texts[0], "%g", value);
    else if (magnitude >= 1e5 || magnitude < 1e-2)
        snprintf(text, sizeof texts[0], "%.1fe%d", value / pow(10, floor(log10(magnitude))), (int)floor(log10(magnitude)));
    else
        snprintf(text, sizeof texts[0], "%.*f", magnitude >= 100 ? 0 : magnitude >= 10 ? 1 : magnitude >= 1 ? 2 : 3, value);
    return text;
}

static bool make_folder(const char *path, char *message, size_t size)
{
    if (mkdir(path, 0777) == 0 || errno == EEXIST) return true;
    message_write(message, size, "%s: cannot be made a folder (%s)", path, strerror(errno));
    return false;
}

bool page_make_folders(const char *topic, const char *folder, const char *name, page_paths *paths, char *message, size_t size)
{
    snprintf(paths->base, sizeof paths->base, "%s%s%s", topic, name ? "-" : "", name ? name : "");
    snprintf(paths->page, sizeof paths->page, "%s/%s.md", folder, paths->base);
    snprintf(paths->plots, sizeof paths->plots, "%s/%s", folder, paths->base);
    return make_folder(folder, message, size) && make_folder(paths->plots, message, size);
}

void page_begin(FILE *file, const char *title, const char *program, const bench_machine *machine)
{
    fprintf(file, "# %s\n\n`%s` wrote this page, every number and every sentence; `./run bench` writes it anew.", title,
            program);
    if (!machine->has_gl_timer)
        fputs(" This machine has no GPU: a software rasteriser drew everything, so the times only mean something beside one "
              "another, "
              "and on a GPU their ratios are others.",
              file);
    fprintf(file, "\n\n- Machine: %s, %ld core%s; %s, OpenGL %s.\n", machine->processor, machine->cores,
            machine->cores == 1 ? "" : "s", machine->renderer, machine->version);
}
