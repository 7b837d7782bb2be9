/*
 * A line on the terminal that says how far a long run is. Nothing is printed where standard error is no terminal.
 */
#ifndef PROGRESS_H
#define PROGRESS_H

/* Replaces the line. */
__attribute__((format(printf, 1, 2))) void progress_show(const char *format, ...);

/* Leaves the line empty. */
void progress_clear(void);

#endif
