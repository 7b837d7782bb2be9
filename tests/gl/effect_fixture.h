/* What the tests of an effect's life share: a float target, a frame and sources to draw there. */
#ifndef TEST_EFFECT_FIXTURE_H
#define TEST_EFFECT_FIXTURE_H

#include "api.h"
#include "energywave.h"

#include <stdbool.h>

enum { PICTURE_WIDTH = 16, PICTURE_HEIGHT = 12 };

typedef struct picture {
    GLfloat pixels[PICTURE_HEIGHT][PICTURE_WIDTH][4];
} picture;

/* A framebuffer of the current context with an RGBA32F attachment of the picture's size, and the attachment's name unless that
 * is NULL. */
GLuint make_target(GLuint *attachment);
GLuint make_framebuffer_of(GLuint renderbuffer);

void clear_target(GLuint framebuffer);
void read_target(GLuint framebuffer, picture *read);

/* A frame that shows all sources of a field. */
ew_frame_desc make_frame(GLuint framebuffer, ew_output output);

/* Sources in front of the frame's camera, the first few of each list in use. */
enum { FIELD_SIZE = 8 };
typedef struct field {
    ew_point points[FIELD_SIZE];
    ew_line lines[FIELD_SIZE];
    ew_torus tori[FIELD_SIZE];
    ew_curve curves[FIELD_SIZE];
    double weights[4];
    ew_sources_desc desc;
} field;

void make_field(field *f, size_t points, size_t lines, size_t tori, size_t curves, bool weighted);

/* The largest difference of two pictures' channels, relative to the largest value of `expected`; huge if `actual` is not
 * finite. */
double picture_difference(const picture *actual, const picture *expected);

#endif
