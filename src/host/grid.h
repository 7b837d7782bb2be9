/* The textures and the passes of adaptive resolution: see glsl/pass/grid.glsl. */
#ifndef EW_GRID_H
#define EW_GRID_H

#include "host/depth_input.h"
#include "host/gl.h"
#include "host/light_sum.h"
#include "host/state_guard.h"
#include "plan/plan.h"
#include "plan/shader_text.h"

/* Peaks of EW_PEAK_SIZE x EW_PEAK_SIZE nodes, of as many of these peaks, and so on: four levels are enough for any viewport. */
enum { EW_GRID_PEAK_LEVELS = 4 };

/* A grid's textures. Starts as {0}, and keeps them from frame to frame. */
typedef struct ew_grid {
    GLuint nodes, middles, field, cells, blocks;
    GLuint peaks[EW_GRID_PEAK_LEVELS];
    int columns, rows; /* of blocks, that there is room for */
    bool is_refused;   /* the driver cannot draw to such textures */
} ew_grid;

/* The programs of a plan, by pass; 0 where the plan has no such pass. */
typedef struct ew_pass_programs {
    GLuint names[EW_PASS_COUNT];
} ew_pass_programs;

/* What is drawn: a plan whose uniforms and depth are bound. Where its sources are drawn in parts, these have programs of their
 * own for the passes that integrate, and that of EW_PASS_WAVE or EW_PASS_CELLS composites their sum. */
typedef struct ew_drawing {
    const ew_gl *gl;
    const ew_plan *plan;
    const ew_depth_input *depth;
    ew_pass_programs programs;
    ew_pass_programs parts[EW_PART_COUNT];
    int part_count; /* 0: all sources are drawn at once */
    GLuint torn;    /* draws all sources in torn cells where they are drawn in parts elsewhere; 0: there are no torn cells */
    bool is_ahead;  /* outside of the view: see ew_execute_ahead */
    GLuint only;    /* of all programs; 0: each is drawn with */
} ew_drawing;

static inline bool ew_draws_with(const ew_drawing *drawing, GLuint program)
{
    return drawing->only == 0 || drawing->only == program;
}

/* Four vertices are a quad; the next ones lie beyond its upper edge, and the triangles that they make are clipped away. */
enum { EW_QUAD_VERTICES = 4 };

void ew_grid_destroy(ew_grid *grid, const ew_gl *gl);

/* Makes room for the plan's viewport, and finds the light of its nodes and the classes of its patches. Changes the draw
 * framebuffer, the viewport and blending. Returns false if GL cannot draw to the textures: then no grid can be drawn in this
 * context. */
bool ew_grid_fill(ew_grid *grid, const ew_drawing *drawing);

/* Sums up the light of the rough cells' pixels of a filled grid, whose sources are drawn in parts. As ew_light_sum_fill. */
bool ew_grid_sum(ew_light_sum *sum, const ew_drawing *drawing);

/* Draws the filled grid's patches to the target, which must be set. */
void ew_grid_draw(const ew_grid *grid, const ew_drawing *drawing);

#endif
