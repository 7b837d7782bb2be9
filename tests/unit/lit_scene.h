/* Random views and sources, and places that the sources light: within reach of a point of theirs. */
#ifndef LIT_SCENE_H
#define LIT_SCENE_H

#include "random_numbers.h"
#include "source_kinds.h"

#include <stdbool.h>

enum { LIT_SCENE_SIZE = 1000 }; /* of the viewport, in pixels */

typedef union any_source {
    ew_point point;
    ew_line line;
    ew_torus torus;
    ew_curve curve;
    ew_path path;
} any_source;

typedef struct lit_scene {
    ew_frame_desc frame;
    ew_sources_desc desc; /* the source alone */
    any_source source;
    double points[MAX_RANDOM_POINTS][3];
    source_view view;
    double reach;
} lit_scene;

/* From (0, 0, 0) along -z; half of the picture is as wide and as high as what is seen is deep. */
ew_frame_desc lit_scene_plain_frame(void);

/* From near -100 to far 100. */
void lit_scene_make_parallel(ew_frame_desc *frame, double half_size);

/* A source about the view's axis, before, beside and behind the eye. Not to be moved. */
void lit_scene_make(lit_scene *made, const source_kind *kind, uint64_t *random);

/* A place at the edge of a source's light, which has no end on infinite lines. */
void lit_scene_place(lit_scene *of, const source_kind *kind, uint64_t *random, double place[3]);

/* NDC and view depth of a place of the world. Returns false where none is seen. */
bool lit_scene_project(const ew_frame_desc *frame, const double world[3], double seen[3]);

#endif
