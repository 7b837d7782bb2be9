/*
 * The growth of a frame's time as a page to read: Markdown with a plot of each sweep.
 */
#ifndef GROWTH_REPORT_H
#define GROWTH_REPORT_H

#include "growth.h"
#include "results.h"

/* Writes FOLDER/growth.md, or FOLDER/growth-NAME.md where `name` is not NULL, and the plots into a folder of the same name
 * without .md, as report.h does. On failure returns false, with a message. */
bool growth_report_write(const growth_sweep sweeps[GROWTH_SWEEPS], const growth_settings *settings,
                         const bench_machine *machine, const char *folder, const char *name, char *message, size_t size);

#endif
