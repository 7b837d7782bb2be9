/*
 * Maps of the method: errors and costs as colours, from black over violet and orange to a pale yellow. No GL.
 */
#ifndef FALSE_COLOR_H
#define FALSE_COLOR_H

/* The ends of the scale of errors, which is logarithmic. */
#define FALSE_COLOR_LEAST_ERROR 1e-6
#define FALSE_COLOR_LARGEST_ERROR 1e-1
/* The upper end of the scale of evaluations, which is logarithmic but for its beginning at 0. */
#define FALSE_COLOR_MOST_EVALUATIONS 4096

/* The colour, 8-bit sRGB, at `at` of the scale, from 0 to 1; what is beyond has the ends' colours. */
void false_color_at(double at, unsigned char srgb[3]);

/* Where a relative error or a number of evaluations stands on its scale. */
double false_color_of_error(double error);
double false_color_of_evaluations(double evaluations);

#endif
