/* Time against error as a picture: see plot.h. */
#include "plot.h"
#include "gnuplot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Colours that are told apart without red or green too (Okabe and Ito). */
static const struct {
    const char *title, *color, *style;
} families[FAMILY_BARE] = {
    [FAMILY_FULL] = {"full", "#56b4e9", "lw 2 pt 6 ps 0.9"},
    [FAMILY_ADAPTIVE] = {"adaptive", "#0072b2", "lw 3 pt 7 ps 0.9"},
    [FAMILY_SIMPSON] = {"Simpson", "#d55e00", "lw 1.5 pt 5 ps 0.6"},
    [FAMILY_MARCHING] = {"uniform marching", "#009e73", "lw 1.5 pt 9 ps 0.7"},
    [FAMILY_EQUIANGULAR] = {"equiangular sampling", "#cc79a7", "lw 1.5 pt 11 ps 0.7"},
    [FAMILY_HALF_MARCHING] = {"half marching", "#009e73", "lw 1.5 dt 2 pt 8 ps 0.8"},
    [FAMILY_BILLBOARDS] = {"billboards", "#e69f00", "lw 1.5 pt 13 ps 0.9"},
    [FAMILY_RIBBON] = {"ribbon", "#999999", "lw 1.5 pt 3 ps 0.9"},
};

typedef struct extent {
    double least;
    double largest;
} extent;

static void extend(extent *range, double value)
{
    range->least = fmin(range->least, value);
    range->largest = fmax(range->largest, value);
}

static bool can_be_drawn(const measurement *point)
{
    return point->ms_median > 0 && point->max_error > 0 && isfinite(point->max_error);
}

/* Writes the points of a family, in the order in which they were named, as a block of data; returns how many there are. */
static size_t write_data(FILE *file, const bench_results *results, const bench_scene *scene, integrator_family family)
{
    size_t count = 0;
    fprintf(file, "$points_%d << END\n", (int)family);
    for (size_t i = 0; i < results->settings.integrator_count; i++) {
        const bench_integrator *integrator = &results->settings.integrators[i];
        const measurement *point = &scene->measurements.integrators[i];
        if (integrator->family != family || !can_be_drawn(point)) continue;
        fprintf(file, "%.6g %.6g %s\n", point->ms_median, point->max_error, strchr(integrator->name, ':') + 1);
        count++;
    }
    fputs("END\n", file);
    return count;
}

static void write_ranges(FILE *file, const bench_results *results, const bench_scene *scene)
{
    extent times = {HUGE_VAL, 0}, errors = {HUGE_VAL, 0};
    for (size_t i = 0; i < results->settings.integrator_count; i++) {
        const measurement *point = &scene->measurements.integrators[i];
        bool bare = results->settings.integrators[i].family == FAMILY_BARE;
        if (bare || can_be_drawn(point)) extend(&times, point->ms_median);
        if (!bare && can_be_drawn(point)) extend(&errors, point->max_error);
    }
    if (times.largest > 0) fprintf(file, "set xrange [%.6g:%.6g]\n", times.least / 2, times.largest * 2);
    if (errors.largest > 0)
        fprintf(file, "set yrange [%.6g:%.6g]\n", pow(10, floor(log10(errors.least / 1.3))),
                pow(10, ceil(log10(errors.largest * 1.3))));
}

/* What is to be drawn. */
typedef struct plotted_scene {
    const bench_results *results;
    const bench_scene *scene;
} plotted_scene;

/* `user` is a plotted_scene. */
static void write_script(FILE *file, const void *user)
{
    const plotted_scene *plotted = user;
    const bench_results *results = plotted->results;
    const bench_scene *scene = plotted->scene;
    const measure_settings *settings = &results->settings;
    const measurement *bare = results_find(results, scene, "bare");
    size_t counts[FAMILY_BARE], drawn = 0;
    for (int family = 0; family < FAMILY_BARE; family++)
        counts[family] = write_data(file, results, scene, (integrator_family)family);
    gnuplot_begin(file, scene->name, scene->name);
    fprintf(file,
            "set xlabel 'milliseconds a frame of %d x %d'\nset ylabel 'largest relative error'\nset format y '10^{%%L}'\n",
            settings->width, settings->height);
    write_ranges(file, results, scene);
    if (bare)
        fprintf(file, "set arrow from %.6g, graph 0 to %.6g, graph 1 nohead dt 2 lw 1.5 lc rgb '#666666'\n", bare->ms_median,
                bare->ms_median);
    fputs("plot ", file);
    for (int family = 0; family < FAMILY_BARE; family++) {
        if (counts[family] == 0) continue;
        fprintf(file, "%s$points_%d using 1:2 with linespoints %s lc rgb '%s' title '%s'", drawn++ > 0 ? ", \\\n     " : "",
                family, families[family].style, families[family].color, families[family].title);
        fprintf(file, ", \\\n     '' using 1:2:3 with labels offset 0.6,0.6 left font ',10' tc rgb '%s' notitle",
                families[family].color);
    }
    if (bare)
        fprintf(file, "%sNaN with lines dt 2 lw 1.5 lc rgb '#666666' title 'a bare pass'", drawn > 0 ? ", \\\n     " : "");
    fputs("\n", file);
}

bool plot_draw(const bench_results *results, const bench_scene *scene, const char *folder, char *message, size_t size)
{
    const plotted_scene plotted = {results, scene};
    return gnuplot_draw(folder, scene->name, write_script, &plotted, message, size);
}
