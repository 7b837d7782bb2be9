/*
 * Errors and costs as colours: from black through violet and orange to pale yellow. No GL.
 */
#ifndef FALSE_COLOR_H
#define FALSE_COLOR_H

/* The ends of the logarithmic scale of errors. */
#define FALSE_COLOR_LEAST_ERROR 1e-6
#define FALSE_COLOR_LARGEST_ERROR 1e-1
/* The upper end of the scale of evaluations, which is that of log(1 + evaluations). */
#define FALSE_COLOR_MOST_EVALUATIONS 4096

/* The colour, in 8-bit sRGB, at a place on the scale from 0 to 1. Beyond the ends it is that of the end. */
void false_color_at(double at, unsigned char srgb[3]);

/* The place of a relative error or of a number of evaluations on its scale. */
double false_color_of_error(double error);
double false_color_of_evaluations(double evaluations);

#endif
