/* The rays of a view through an interval of depths, as the shader gets them: see struct ew_frame_block. */
#ifndef EW_RAYS_H
#define EW_RAYS_H

#include "model/ray_space.h"
#include "model/view.h"

/* The view depths of S and E, between which all rays run. In the world integral S may be the eye of a perspective view. */
typedef struct ew_interval {
    double start, end;
} ew_interval;

/* The eye itself has no window depth: there, the first depth that has one is this share of the last. */
#define EW_MIN_DEPTH_RATIO 1e-9

/* Checks an interval that is seen in a checked view. */
ew_result ew_check_interval(const ew_interval *interval, const ew_view *view, ew_error *error);

/* Checks that no ray, nor its window depth, leaves the range of the shader's numbers. */
ew_result ew_check_rays(const ew_view *view, const ew_interval *interval, ew_error *error);

/* A rectangle of pixels. */
typedef struct ew_viewport {
    int x, y, width, height;
} ew_viewport;

/* With lengths in `unit`, fills the members of `block` from which a pixel of the viewport gets its ray, and from its window
 * depth its end. */
void ew_pack_rays(const ew_view *view, const ew_interval *interval, double unit, const ew_viewport *viewport,
                  struct ew_frame_block *block);

/* Fills those members of `block` that say where a ray ends for depths that are view depths, not window depths. */
void ew_pack_linear_depth(const ew_interval *interval, struct ew_frame_block *block);

/* The height of a pixel per unit of view depth; of a parallel projection, in world units. */
double ew_pixel_height(const ew_view *view, const ew_viewport *viewport);

/* Fills the rows that bring what is relative to the eye to ray space, for shaders of the host's. */
void ew_pack_ray_space(const ew_ray_space *space, struct ew_frame_block *block);

#endif
