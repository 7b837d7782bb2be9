/* The checks of a frame that need no GL. */
#ifndef EW_FRAME_H
#define EW_FRAME_H

#include "energywave.h"

#include <stdbool.h>

/* Whether the frame asks for the world integral: it has no interval. */
bool ew_is_world_frame(const ew_frame_desc *frame);

/* Whether it asks for the light on surfaces. */
bool ew_draws_surfaces(const ew_frame_desc *frame);

/* The frame's core_pixels, or the default of its integral. */
double ew_core_pixels_of(const ew_frame_desc *frame);

/* Whether there is fog, and whether it changes with height. */
bool ew_has_fog(const ew_frame_desc *frame);
bool ew_has_height_fog(const ew_frame_desc *frame);

/* Whether it draws a picture, with the media that it has. */
bool ew_draws_picture(const ew_frame_desc *frame);

/* The frame with what the host leaves to us: its view is the rotation next to it, and its projection is turned over if NDC's y
 * points down in the target. A frame that ew_check_integral refuses is refused as before. */
ew_frame_desc ew_settle_frame(const ew_frame_desc *frame, bool is_upside_down);

/* Checks what the integral depends on: view, interval, decay, fog, media and integrator. */
ew_result ew_check_integral(const ew_frame_desc *frame, ew_error *error);

/* Checks where and how the light is drawn: viewport, output, encoding, dither, depth and restoration. */
ew_result ew_check_target(const ew_frame_desc *frame, ew_error *error);

#endif
