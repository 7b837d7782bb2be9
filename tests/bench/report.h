/*
 * The measurements as a page to read: Markdown with a plot of time against error for every scene.
 */
#ifndef REPORT_H
#define REPORT_H

#include "results.h"

/* Writes FOLDER/speed-and-error.md, or FOLDER/speed-and-error-NAME.md where `name` is not NULL, and the plots into a folder of
 * the same name without .md. They are drawn by gnuplot; where it is missing, its scripts are left there instead, and the
 * message says so. Each set becomes a part of the page; no two scenes share a name. On failure returns false, with a message.
 */
bool report_write(const bench_results *sets, size_t set_count, const char *folder, const char *name, char *message,
                  size_t size);

#endif
