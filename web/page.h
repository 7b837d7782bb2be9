/*
 * What the page asks of the library: a scene file's text becomes the scene, and the scene a picture on the canvas. The page
 * keeps the text; this keeps what was made of it. Functions that return a message return an empty one on success. It is valid
 * until the next call.
 */
#ifndef PAGE_H
#define PAGE_H

#include <stdbool.h>
#include <stddef.h>

/* Creates the context on the page's canvas, and shows the court. */
const char *page_start(void);

/* What draws, as GL calls it. */
const char *page_renderer(void);

/* Shows the court as it is at `seconds`. */
void page_show_court(double seconds);

/* Shows the scene of a scene file. A text with a fault changes nothing. */
const char *page_show_file(const char *text, size_t length);

/* Returns what is shown as the text of a scene file, valid until the next call of this function; NULL where memory is
 * exhausted. */
const char *page_write(void);

/* Looks from another place, until something else is shown. `height` is what an orthographic camera sees of it. */
void page_set_camera(double eye_x, double eye_y, double eye_z, double target_x, double target_y, double target_z, double up_x,
                     double up_y, double up_z, double height);

/* Returns what is seen at a place of the picture, as its list and its index: "paths/2"; or an empty text. The place is from -1
 * to 1, to the right and up, and as wide as `width`, on the same scale. `aspect` is the picture's. */
const char *page_pick(double x, double y, double aspect, double width);

/* The weights of a travelling pulse: see ew_fill_pulse_weights. */
void page_fill_pulse(double frame, double *weights, size_t count);

/* How the picture, or its right half, is integrated: `quality` and `divisions` matter to one integrator each. */
void page_set_integrator(bool is_right, int integrator, int quality, int divisions);

void page_set_view(int mode, bool split);

/* Takes one step of what must be compiled before the scene can be drawn without waiting. Returns how many steps are left, or -1
 * on failure, which page_draw explains. */
int page_prepare(int width, int height);

/* Draws the picture into the display's own framebuffer. */
const char *page_draw(int width, int height);

/* Brings the picture to the canvas, which is as large. */
void page_present(void);

/* Returns the picture's pixels: 4 bytes each, rows from the bottom up, valid until the next call of this function; NULL where
 * memory is exhausted. */
const unsigned char *page_read(void);

/* A number about the last picture's left (0) or right (1) half: the mean of evaluations, the largest error, or the error that
 * 99 % of the pixels keep; negative where it is unknown. */
double page_statistic(int half, int which);

#endif
