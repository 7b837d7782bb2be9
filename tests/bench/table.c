/* The measurements as rows: see table.h. */
#include "table.h"

bool table_write_csv_header(FILE *file)
{
    fputs("scene,integrator,size,renderer,ms_median,ms_min,evaluations_per_pixel,max_rel_error,p99_rel_error,"
          "brightness\n",
          file);
    return fflush(file) == 0;
}

static void write_quoted(FILE *file, const char *text)
{
    fputc('"', file);
    for (; *text; text++) {
        if (*text == '"') fputc('"', file);
        fputc(*text, file);
    }
    fputc('"', file);
}

bool table_write_csv(FILE *file, const bench_results *results, const bench_scene *scene)
{
    const measure_settings *settings = &results->settings;
    for (size_t i = 0; i < settings->integrator_count; i++) {
        const measurement *row = &scene->measurements.integrators[i];
        fprintf(file, "%s,%s,%dx%d,", scene->name, settings->integrators[i].name, settings->width, settings->height);
        write_quoted(file, results->machine.renderer);
        fprintf(file, ",%.6g,%.6g,%.6g,", row->ms_median, row->ms_min, row->evaluations_per_pixel);
        if (settings->integrators[i].family == FAMILY_BARE)
            fputs(",,\n", file);
        else
            fprintf(file, "%.6g,%.6g,%.6g\n", row->max_error, row->p99_error, row->brightness);
    }
    return fflush(file) == 0 && !ferror(file);
}

void table_print(const bench_results *results, const bench_scene *scene)
{
    const measure_settings *settings = &results->settings;
    printf("%s\n  %-18s %12s %12s %13s %11s %11s %11s\n", scene->name, "integrator", "ms, median", "ms, least",
           "evaluations/px", "max error", "99 % below", "brightness");
    for (size_t i = 0; i < settings->integrator_count; i++) {
        const measurement *row = &scene->measurements.integrators[i];
        printf("  %-18s %12.3f %12.3f", settings->integrators[i].name, row->ms_median, row->ms_min);
        if (settings->integrators[i].family == FAMILY_BARE)
            printf("\n");
        else
            printf(" %14.1f %11.2e %11.2e %11.3f\n", row->evaluations_per_pixel, row->max_error, row->p99_error,
                   row->brightness);
    }
    fflush(stdout);
}
