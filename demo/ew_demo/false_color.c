/* Errors and costs as colours: see false_color.h. */
#include "false_color.h"

#include <math.h>

void false_color_at(double at, unsigned char srgb[3])
{
    static const unsigned char stops[][3] = {{0, 0, 4},     {60, 15, 110},  {150, 40, 110},
                                             {222, 90, 50}, {252, 170, 30}, {252, 255, 190}};
    enum { LAST = sizeof stops / sizeof *stops - 1 };
    double place = fmin(fmax(at, 0), 1) * LAST;
    int stop = place < LAST ? (int)place : LAST - 1;
    for (int i = 0; i < 3; i++)
        srgb[i] = (unsigned char)(stops[stop][i] + (place - stop) * (stops[stop + 1][i] - stops[stop][i]) + 0.5);
}

double false_color_of_error(double error)
{
    return log(fmax(error, FALSE_COLOR_LEAST_ERROR) / FALSE_COLOR_LEAST_ERROR) /
           log(FALSE_COLOR_LARGEST_ERROR / FALSE_COLOR_LEAST_ERROR);
}

double false_color_of_evaluations(double evaluations)
{
    return log(1 + evaluations) / log(1.0 + FALSE_COLOR_MOST_EVALUATIONS);
}
