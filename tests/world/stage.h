/* A float target, a camera before the origin, and what is drawn there: for tests of what the world integral promises. */
#ifndef TEST_WORLD_STAGE_H
#define TEST_WORLD_STAGE_H

#include "canvas.h"
#include "energywave.h"

#include <stdbool.h>

enum { STAGE_WIDTH = 97, STAGE_HEIGHT = 65, STAGE_VALUES = 4 * STAGE_WIDTH * STAGE_HEIGHT };

typedef GLfloat stage_picture[STAGE_HEIGHT][STAGE_WIDTH][4];

/* Opens the context of that name and makes the target and an effect. False, with a line on stderr, without such a context. */
bool stage_open(const char *context_name);
void stage_close(void);

/* The effect's, for calls that do not draw. */
ew_effect *stage_effect(void);

/* A world frame of the camera at (0, 0, distance), which looks at the origin with a field of view of 45 degrees. */
ew_frame_desc stage_frame(double distance);

/* Half of the picture's height at a view depth of 1. */
double stage_slope(void);

/* The height of a pixel at that view depth. */
double stage_pixel(double depth);

void stage_set(const ew_sources_desc *sources);

/* Draws over a background, and fails the test where the effect does. */
void stage_draw(const ew_frame_desc *frame, const GLfloat background[4], stage_picture drawn);

/* Draws the luminance. */
void stage_measure(const ew_frame_desc *frame, stage_picture measured);

/* The largest luminance of a picture. */
double stage_peak(stage_picture measured);

/* The largest difference of two luminances, relative to max(expected, 1e-3 of the largest expected). */
double stage_difference(stage_picture measured, stage_picture expected);

/* The distance of a pixel's ray from the origin, for a camera of stage_frame. */
double stage_ray_distance(double distance, int column, int row);

/* The luminance of an orb whose middle a ray passes at `miss`, up to `end` beyond the place that is nearest to it: its
 * definition, by Simpson's rule on each side of the core's edges. */
double stage_orb(double brightness, double core, double reach, double miss, double end);

/* A depth texture for the target, of one window depth everywhere. The caller deletes it. */
GLuint stage_make_depth(double depth);

#endif
