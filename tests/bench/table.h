/*
 * The measurements as rows: comma-separated, and for the eye.
 */
#ifndef TABLE_H
#define TABLE_H

#include "results.h"

#include <stdio.h>

/* scene,integrator,size,renderer,ms_median,ms_min,evaluations_per_pixel,max_rel_error,p99_rel_error,brightness. The bare pass
 * has no errors: its fields are empty. Each returns whether all was written. */
bool table_write_csv_header(FILE *file);
bool table_write_csv(FILE *file, const bench_results *results, const bench_scene *scene);

void table_print(const bench_results *results, const bench_scene *scene);

#endif
