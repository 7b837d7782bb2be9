/* The passes of adaptive resolution: see grid.h. */
#include "host/grid.h"

#include "host/sample_passes.h"

/* Columns and rows of nodes, cells or blocks. */
typedef struct extent {
    int columns, rows;
} extent;

/* The parts of a viewport's grid. */
typedef struct grid_extents {
    extent cells, blocks, nodes;
} grid_extents;

static extent divide_up(extent a, int b)
{
    return (extent){(a.columns + b - 1) / b, (a.rows + b - 1) / b};
}

static extent nodes_of(extent blocks)
{
    const int others = 1 + 2 * EW_NODE_MARGIN;
    return (extent){blocks.columns * EW_BLOCK_CELLS + others, blocks.rows * EW_BLOCK_CELLS + others};
}

static grid_extents extents_of(const ew_viewport *viewport)
{
    const extent cells = divide_up((extent){viewport->width, viewport->height}, EW_CELL_SIZE);
    const extent blocks = divide_up(cells, EW_BLOCK_CELLS);
    return (grid_extents){cells, blocks, nodes_of(blocks)};
}

/* ---- Textures ---- */

static void allocate(const ew_gl *gl, GLuint *texture, GLint internal_format, GLenum format, GLenum type, extent size)
{
    if (!*texture) gl->GenTextures(1, texture);
    gl->BindTexture(GL_TEXTURE_2D, *texture);
    ew_gl_allocate(gl, GL_TEXTURE_2D, internal_format, size.columns, size.rows, format, type);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/* Gives the textures room for that many blocks, never less than before. */
static void grow(ew_grid *grid, const ew_gl *gl, extent blocks)
{
    if (blocks.columns <= grid->columns && blocks.rows <= grid->rows) return;
    if (blocks.columns > grid->columns) grid->columns = blocks.columns;
    if (blocks.rows > grid->rows) grid->rows = blocks.rows;
    const extent room = {grid->columns, grid->rows}, nodes = nodes_of(room);
    allocate(gl, &grid->nodes, GL_RGBA32F, GL_RGBA, GL_FLOAT, nodes);
    allocate(gl, &grid->middles, GL_RGBA32F, GL_RGBA, GL_FLOAT, nodes);
    allocate(gl, &grid->field, GL_R32F, GL_RED, GL_FLOAT, nodes);
    allocate(gl, &grid->cells, GL_R8, GL_RED, GL_UNSIGNED_BYTE,
             (extent){room.columns * EW_BLOCK_CELLS, room.rows * EW_BLOCK_CELLS});
    allocate(gl, &grid->blocks, GL_R8, GL_RED, GL_UNSIGNED_BYTE, room);
    extent peaks = nodes;
    for (int level = 0; level < EW_GRID_PEAK_LEVELS; ++level) {
        peaks = divide_up(peaks, EW_PEAK_SIZE);
        allocate(gl, &grid->peaks[level], GL_RGBA32F, GL_RGBA, GL_FLOAT, peaks);
    }
}

void ew_grid_destroy(ew_grid *grid, const ew_gl *gl)
{
    const GLuint textures[] = {grid->nodes, grid->middles, grid->field, grid->cells, grid->blocks};
    gl->DeleteTextures(sizeof textures / sizeof textures[0], textures);
    gl->DeleteTextures(EW_GRID_PEAK_LEVELS, grid->peaks);
    *grid = (ew_grid){0};
}

/* ---- Passes ---- */

static void bind(const ew_gl *gl, int unit, GLuint texture)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->BindSampler((GLuint)unit, 0);
}

/* Sets the width of the patches, in cells, of the program in use. */
static void set_stride(const ew_gl *gl, GLuint program, int stride)
{
    gl->Uniform1i(gl->GetUniformLocation(program, "ew_stride"), stride);
}

/* Uses a program that reads the depth's samples up to `end` as one surface, if depth has samples. */
static void use_with_samples(const ew_drawing *drawing, GLuint program, GLint end)
{
    const ew_gl *gl = drawing->gl;
    gl->UseProgram(program);
    if (drawing->depth->samples > 0) ew_choose_samples(gl, program, 0, end, EW_ONE_SURFACE);
}

/* Draws a quad over the first `size` texels of a texture of the grid. */
static void fill(const ew_drawing *drawing, GLuint texture, extent size)
{
    const ew_gl *gl = drawing->gl;
    gl->FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    ew_gl_set_viewport(gl, &(ew_viewport){0, 0, size.columns, size.rows});
    gl->DrawArrays(GL_TRIANGLE_STRIP, drawing->is_ahead ? EW_QUAD_VERTICES : 0, EW_QUAD_VERTICES);
}

/* Fills both textures of nodes, or adds to them. */
static void fill_nodes(const ew_grid *grid, const ew_drawing *drawing, extent size, GLuint program)
{
    const ew_gl *gl = drawing->gl;
    if (!ew_draws_with(drawing, program)) return;
    use_with_samples(drawing, program, 1);
    const GLint offset = gl->GetUniformLocation(program, "ew_node_offset");
    gl->Uniform1i(offset, 0);
    fill(drawing, grid->nodes, size);
    gl->Uniform1i(offset, EW_CELL_SIZE / 2);
    fill(drawing, grid->middles, size);
}

static void fill_nodes_with_all(const ew_grid *grid, const ew_drawing *drawing, extent size)
{
    if (drawing->part_count == 0) fill_nodes(grid, drawing, size, drawing->programs.names[EW_PASS_NODES]);
    for (int part = 0; part < drawing->part_count; ++part) {
        ew_gl_set_sum(drawing->gl, part > 0);
        fill_nodes(grid, drawing, size, drawing->parts[part].names[EW_PASS_NODES]);
    }
    ew_gl_set_blend(drawing->gl, false);
}

static void fill_field(const ew_grid *grid, const ew_drawing *drawing, extent size)
{
    const GLuint program = drawing->programs.names[EW_PASS_FIELD];
    if (!ew_draws_with(drawing, program)) return;
    use_with_samples(drawing, program, 1);
    fill(drawing, grid->field, size);
}

/* Finds the peak of the nodes, and binds the texture whose first texel it is. */
static void fill_peaks(const ew_grid *grid, const ew_drawing *drawing, extent nodes)
{
    const ew_gl *gl = drawing->gl;
    GLuint source = grid->nodes, program = drawing->programs.names[EW_PASS_PEAK];
    if (!ew_draws_with(drawing, program)) return;
    GLint source_size = gl->GetUniformLocation(program, "ew_source_size");
    extent size = nodes;
    gl->UseProgram(program);
    for (int level = 0; level < EW_GRID_PEAK_LEVELS && (level == 0 || size.columns * size.rows > 1); ++level) {
        bind(gl, EW_GL_NODE_TEXTURE_UNIT, source);
        gl->Uniform2i(source_size, size.columns, size.rows);
        size = divide_up(size, EW_PEAK_SIZE);
        source = grid->peaks[level];
        fill(drawing, source, size);
    }
    bind(gl, EW_GL_BLOCK_TEXTURE_UNIT, source);
}

static void fill_classes(const ew_grid *grid, const ew_drawing *drawing, const grid_extents *extents)
{
    const ew_gl *gl = drawing->gl;
    const GLuint program = drawing->programs.names[EW_PASS_CLASSES];
    if (!ew_draws_with(drawing, program)) return;
    use_with_samples(drawing, program, drawing->depth->samples);
    set_stride(gl, program, 1);
    fill(drawing, grid->cells, extents->cells);
    bind(gl, EW_GL_CELL_TEXTURE_UNIT, grid->cells);
    set_stride(gl, program, EW_BLOCK_CELLS);
    fill(drawing, grid->blocks, extents->blocks);
}

static void fill_textures(const ew_grid *grid, const ew_drawing *drawing, const grid_extents *extents)
{
    const ew_gl *gl = drawing->gl;
    fill_nodes_with_all(grid, drawing, extents->nodes);
    fill_field(grid, drawing, extents->nodes);
    fill_peaks(grid, drawing, extents->nodes);
    bind(gl, EW_GL_NODE_TEXTURE_UNIT, grid->nodes);
    bind(gl, EW_GL_MIDDLE_TEXTURE_UNIT, grid->middles);
    bind(gl, EW_GL_FIELD_TEXTURE_UNIT, grid->field);
    fill_classes(grid, drawing, extents);
    bind(gl, EW_GL_CELL_TEXTURE_UNIT, grid->cells);
}

bool ew_grid_fill(ew_grid *grid, const ew_drawing *drawing)
{
    const ew_gl *gl = drawing->gl;
    const grid_extents extents = extents_of(&drawing->plan->lit), whole = extents_of(&drawing->plan->target.viewport);
    GLuint framebuffer;
    for (int unit = EW_GL_NODE_TEXTURE_UNIT; unit < EW_GL_TEXTURE_UNIT_COUNT; ++unit)
        bind(gl, unit, 0);
    grow(grid, gl, whole.blocks);
    /* It serves one frame only, since contexts do not share framebuffers. */
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, grid->nodes, 0);
    grid->is_refused = gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE;
    if (!grid->is_refused) {
        ew_gl_set_blend(gl, false);
        fill_textures(grid, drawing, &extents);
    }
    gl->DeleteFramebuffers(1, &framebuffer);
    return !grid->is_refused;
}

/* ---- Patches ---- */

/* Draws patches that are `stride` cells wide, or with a stride of 0 quarters of cells, with the program in use, from the pixel
 * (x, y) of the target on. The last ones may reach beyond the viewport; a point behind them all lies outside of it. */
static void draw_patches(const ew_drawing *drawing, int x, int y, extent patches, int stride)
{
    int width = stride > 0 ? stride * EW_CELL_SIZE : EW_CELL_SIZE / 2, count = patches.columns * patches.rows;
    ew_gl_set_viewport(drawing->gl, &(ew_viewport){x, y, patches.columns * width, patches.rows * width});
    drawing->gl->DrawArrays(GL_POINTS, drawing->is_ahead ? count : 0, drawing->is_ahead ? 1 : count);
}

static void set_flag(const ew_gl *gl, GLuint program, const char *name, bool value)
{
    gl->Uniform1i(gl->GetUniformLocation(program, name), value);
}

static void draw_rough_cells(const ew_drawing *drawing, GLuint program, int x, int y)
{
    set_stride(drawing->gl, program, 1);
    set_flag(drawing->gl, program, "ew_draws_torn", false);
    draw_patches(drawing, x, y, extents_of(&drawing->plan->lit).cells, 1);
}

/* Draws the light of a part. */
static void draw_rough_cells_of_part(void *user, int part)
{
    const ew_drawing *drawing = user;
    const GLuint program = drawing->parts[part].names[EW_PASS_CELLS];
    if (!ew_draws_with(drawing, program)) return;
    use_with_samples(drawing, program, drawing->depth->samples);
    draw_rough_cells(drawing, program, 0, 0);
}

bool ew_grid_sum(ew_light_sum *sum, const ew_drawing *drawing)
{
    const extent cells = extents_of(&drawing->plan->lit).cells;
    return ew_light_sum_fill(sum, drawing->gl, cells.columns * EW_CELL_SIZE, cells.rows * EW_CELL_SIZE, drawing->part_count,
                             draw_rough_cells_of_part, (void *)drawing);
}

/* What draws the torn cells. */
static GLuint program_of_torn(const ew_drawing *drawing)
{
    return drawing->torn ? drawing->torn : drawing->programs.names[EW_PASS_CELLS];
}

/* Of torn cells, only the quarters that are torn can have pixels that see more than one surface. */
static void draw_surfaces(void *user, GLint surface_rank)
{
    const ew_drawing *drawing = user;
    const ew_viewport *lit = &drawing->plan->lit;
    const extent quarters = divide_up((extent){lit->width, lit->height}, EW_CELL_SIZE / 2);
    const int stride = surface_rank > 0 ? 0 : 1;
    set_stride(drawing->gl, program_of_torn(drawing), stride);
    draw_patches(drawing, lit->x, lit->y, stride > 0 ? extents_of(lit).cells : quarters, stride);
}

static void draw_torn_cells(const ew_drawing *drawing)
{
    const GLuint program = program_of_torn(drawing);
    if (!ew_draws_with(drawing, program)) return;
    drawing->gl->UseProgram(program);
    set_flag(drawing->gl, program, "ew_draws_torn", true);
    ew_draw_samples(drawing->gl, program, drawing->depth->samples, draw_surfaces, (void *)drawing);
}

static void draw_smooth_patches(const ew_grid *grid, const ew_drawing *drawing, GLuint program)
{
    const ew_gl *gl = drawing->gl;
    const ew_viewport *lit = &drawing->plan->lit;
    const grid_extents extents = extents_of(lit);
    bind(gl, EW_GL_BLOCK_TEXTURE_UNIT, grid->blocks);
    gl->UseProgram(program);
    set_stride(gl, program, EW_BLOCK_CELLS);
    draw_patches(drawing, lit->x, lit->y, extents.blocks, EW_BLOCK_CELLS);
    set_stride(gl, program, 1);
    draw_patches(drawing, lit->x, lit->y, extents.cells, 1);
}

void ew_grid_draw(const ew_grid *grid, const ew_drawing *drawing)
{
    const GLuint interpolation = drawing->programs.names[EW_PASS_INTERPOLATION], cells = drawing->programs.names[EW_PASS_CELLS];
    const ew_viewport *lit = &drawing->plan->lit;
    if (ew_draws_with(drawing, interpolation)) draw_smooth_patches(grid, drawing, interpolation);
    if (ew_draws_with(drawing, cells)) {
        use_with_samples(drawing, cells, drawing->depth->samples);
        draw_rough_cells(drawing, cells, lit->x, lit->y);
    }
    if (drawing->depth->samples > 0) draw_torn_cells(drawing);
}
