/*
 * Time against error as a picture.
 */
#ifndef PLOT_H
#define PLOT_H

#include "results.h"

/* Draws FOLDER/SCENE.svg with gnuplot. Where that fails, FOLDER/SCENE.gnuplot is left, which draws it when gnuplot runs there.
 * On failure returns false, with a message. */
bool plot_draw(const bench_results *results, const bench_scene *scene, const char *folder, char *message, size_t size);

#endif
