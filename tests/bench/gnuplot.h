/*
 * Pictures that gnuplot draws.
 */
#ifndef GNUPLOT_H
#define GNUPLOT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Has FOLDER/NAME.gnuplot written by `write`, and run in the folder. Where that fails, the script is left, to be run where
 * there is gnuplot. On failure returns false, with a message. */
bool gnuplot_draw(const char *folder, const char *name, void (*write)(FILE *script, const void *user), const void *user,
                  char *message, size_t size);

/* Writes what all scripts begin with: the terminal, the output NAME.svg, logarithmic axes, a grid and a key on top. */
void gnuplot_begin(FILE *script, const char *name, const char *title);

#endif
