/*
 * Benchmarks that measure pictures of one size, print tables, and write them to a page without plots.
 */
#ifndef TABLE_PROGRAM_H
#define TABLE_PROGRAM_H

#include "context.h"
#include "page.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct table_settings {
    int width, height;  /* of the pictures */
    const char *report; /* the page's folder; NULL for no page */
    const char *name;   /* of the machine, behind the topic; NULL for none */
    context_backend backend;
} table_settings;

typedef struct table_program {
    const char *name;
    const char *purpose;       /* a sentence, for --help */
    const char *topic, *title; /* of the page */
    /* Measures, and prints. Where settings->report says so, writes the page. On failure returns false, with a message. */
    bool (*run)(gl_context *context, const table_settings *settings, char *message, size_t size);
} table_program;

/* Opens the page and begins it, and describes the machine. Closed by output_file_close(file, path...). On failure returns NULL,
 * with a message. */
FILE *table_page_open(const table_program *program, gl_context *context, const table_settings *settings, bench_machine *machine,
                      char path[4096], char *message, size_t size);

/* main(): reads the options, and runs the program in a context. */
int table_program_main(const table_program *program, int argc, char **argv);

#endif
