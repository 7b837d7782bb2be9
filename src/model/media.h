/* Media: bodies that dim what is behind them. */
#ifndef EW_MEDIA_H
#define EW_MEDIA_H

#include "model/kinds.h"
#include "model/lit_space.h"

/* Checks a frame's media, but for what depends on the view. */
ew_result ew_check_media(const ew_medium *media, size_t count, ew_error *error);

/* Fills the blocks of checked media, boxes first, and the counts of the fog's block. `exposure` is a factor on their light. */
ew_result ew_pack_media(const ew_medium *media, size_t count, const ew_ray_space *space, double exposure,
                        struct ew_uniform_head *head, ew_error *error);

/* The space of rays from the eye, or from the near plane of a parallel projection, through all of the checked media. Returns
 * false if all of these are behind it. */
bool ew_find_media_space(const ew_medium *media, size_t count, const ew_view *view, ew_lit_space *space);

/* A face of the block that a body's half axes span, which the body does not leave. */
enum { EW_MEDIUM_FACES = 6 };
ew_hull ew_face_of_medium(const ew_medium *medium, int face);

#endif
