/* The growth of a frame's time as a page: see growth_report.h. */
#include "growth_report.h"
#include "gnuplot.h"
#include "output_file.h"
#include "page.h"

#include <stdio.h>

/* Of the series: told apart without red or green too (Okabe and Ito). */
static const char *const colors[GROWTH_SERIES] = {"#0072b2", "#d55e00", "#009e73"};

static void write_introduction(FILE *file, const growth_settings *settings, const bench_machine *machine)
{
    page_begin(file, "How a frame's time grows", "ew-bench-growth", machine);
    fprintf(file,
            "- Frames have %d x %d pixels where nothing else is said, and are drawn onto half floats, added to what is there.\n"
            "- Time: the median of frames of about a second in all, %s.\n"
            "- Exponent: p of the power law y ~ x^p that is nearest to the upper half of the points, by least squares of "
            "logarithms. 0: "
            "no growth; 1: twice as many take twice as long.\n\n"
            "What a frame costs beside what others draw is in [Speed against error](speed-and-error.md).\n\n",
            settings->width, settings->height,
            machine->has_gl_timer ? "by GL's own timer" : "by the wall clock from `glFinish` to `glFinish`");
}

static void write_sweep(FILE *file, const growth_sweep *sweep, const char *base)
{
    fprintf(file, "## %s\n\n%s%s%s\n\n| %s |", sweep->title, sweep->sentence, sweep->end[0] ? " " : "", sweep->end,
            sweep->x_title);
    for (int i = 0; sweep->series[i]; i++)
        fprintf(file, " %s, %s |", sweep->series[i], sweep->y_title);
    if (sweep->beside) fprintf(file, " %s |", sweep->beside);
    fputs("\n|--:|", file);
    for (int i = 0; sweep->series[i]; i++)
        fputs("--:|", file);
    fputs(sweep->beside ? "--:|\n" : "\n", file);
    for (size_t k = 0; k < sweep->count; k++) {
        const growth_point *point = &sweep->points[k];
        fprintf(file, "| %.7g |", point->x);
        for (int i = 0; sweep->series[i]; i++)
            fprintf(file, " %s |", page_number(point->y[i]));
        if (sweep->beside) fprintf(file, " %s |", page_number(point->beside));
        fputs("\n", file);
    }
    fputs("| exponent |", file);
    for (size_t i = 0; sweep->series[i]; i++)
        fprintf(file, " %.2f |", growth_exponent(sweep, i));
    fprintf(file, "%s\n\n![%s against %s, on logarithmic axes](%s/%s.svg)\n\n", sweep->beside ? " |" : "", sweep->y_title,
            sweep->x_title, base, sweep->name);
}

/* `user` is a growth_sweep. */
static void write_script(FILE *script, const void *user)
{
    const growth_sweep *sweep = user;
    fputs("$points << END\n", script);
    for (size_t k = 0; k < sweep->count; k++) {
        fprintf(script, "%.6g", sweep->points[k].x);
        for (int i = 0; sweep->series[i]; i++)
            fprintf(script, " %.6g", sweep->points[k].y[i]);
        fputs("\n", script);
    }
    fputs("END\n", script);
    gnuplot_begin(script, sweep->name, sweep->title);
    fprintf(script, "set xlabel '%s'\nset ylabel '%s'\nplot ", sweep->x_title, sweep->y_title);
    for (size_t i = 0; sweep->series[i]; i++)
        fprintf(script,
                "%s$points using 1:%zu with linespoints lw 2 pt 7 ps 0.9 lc rgb '%s' title '%s: exponent %.2f' noenhanced",
                i > 0 ? ", \\\n     " : "", i + 2, colors[i], sweep->series[i], growth_exponent(sweep, i));
    fputs("\n", script);
}

bool growth_report_write(const growth_sweep sweeps[GROWTH_SWEEPS], const growth_settings *settings,
                         const bench_machine *machine, const char *folder, const char *name, char *message, size_t size)
{
    page_paths paths;
    if (!page_make_folders("growth", folder, name, &paths, message, size)) return false;
    FILE *file = fopen(paths.page, "w");
    if (file) write_introduction(file, settings, machine);
    for (int i = 0; file && i < GROWTH_SWEEPS; i++)
        write_sweep(file, &sweeps[i], paths.base);
    if (!output_file_close(file, paths.page, message, size)) return false;
    bool drawn = true;
    for (int i = 0; i < GROWTH_SWEEPS; i++)
        drawn = gnuplot_draw(paths.plots, sweeps[i].name, write_script, &sweeps[i], message, size) && drawn;
    return drawn;
}
