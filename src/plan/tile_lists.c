/* Lists of sources by tile: see tile_lists.h. */
#include "plan/tile_lists.h"

#include "base/error.h"
#include "model/cone.h"
#include "model/hull.h"
#include "model/silhouette.h"

#include <string.h>

/* In pixels: how far nodes lie, and tiles go on, beyond the viewport's blocks on each side; and how wide blocks are. */
enum { MARGIN = EW_NODE_MARGIN * EW_CELL_SIZE, BLOCK = EW_BLOCK_CELLS * EW_CELL_SIZE };

/* A tile that is wider than any viewport that a context takes; the largest viewport that has lists, and how far away it may
 * begin. */
enum { ONE_TILE_LOG2 = 20, MAX_VIEWPORT = 1 << 18, MAX_ORIGIN = 1 << 30 };

static bool is_countable(const ew_viewport *viewport)
{
    return viewport->width <= MAX_VIEWPORT && viewport->height <= MAX_VIEWPORT && viewport->x >= -MAX_ORIGIN &&
           viewport->x <= MAX_ORIGIN && viewport->y >= -MAX_ORIGIN && viewport->y <= MAX_ORIGIN;
}

static int blocks_in(int pixels)
{
    return (pixels + BLOCK - 1) / BLOCK;
}

static int tiles_over(int pixels, int size_log2)
{
    return ((blocks_in(pixels) * BLOCK + 2 * MARGIN) >> size_log2) + 1;
}

/* ---- Room ---- */

enum { ENTRIES_IN_UNIT = 2 * sizeof(ew_vec4) / sizeof(uint32_t), MAX_TEXTURE_ENTRIES = 1 << 20 };

ew_list_room ew_list_room_of_block(size_t units)
{
    return (ew_list_room){units * ENTRIES_IN_UNIT, false};
}

ew_list_room ew_list_room_of_texture(void)
{
    return (ew_list_room){MAX_TEXTURE_ENTRIES, true};
}

/* ---- Memory ---- */

/* Returns room for `count` elements in place of `memory`, whose first `used` are kept; NULL if there is none. */
static void *grow(void *memory, size_t *capacity, size_t used, size_t count, size_t size, const ew_allocator *allocator)
{
    if (count <= *capacity) return memory;
    size_t wanted = count > 2 * *capacity ? count : 2 * *capacity;
    void *grown = allocator->allocate(allocator->user, wanted * size);
    if (!grown) return NULL;
    if (used > 0) memcpy(grown, memory, used * size);
    if (memory) allocator->deallocate(allocator->user, memory);
    *capacity = wanted;
    return grown;
}

static bool reserve_pairs(ew_tile_lists *lists, size_t count, const ew_allocator *allocator)
{
    void *pairs = grow(lists->pairs, &lists->pair_capacity, lists->pair_count, count, sizeof *lists->pairs, allocator);
    if (pairs) lists->pairs = pairs;
    return pairs;
}

static bool reserve_words(ew_tile_lists *lists, size_t count, const ew_allocator *allocator)
{
    void *words = grow(lists->words, &lists->word_capacity, 0, count, sizeof *lists->words, allocator);
    if (words) lists->words = words;
    return words;
}

static bool reserve_last_pairs(ew_tile_lists *lists, size_t count, const ew_allocator *allocator)
{
    void *last = grow(lists->last_pairs, &lists->last_pair_capacity, 0, count, sizeof *lists->last_pairs, allocator);
    if (last) lists->last_pairs = last;
    return last;
}

void ew_destroy_tile_lists(ew_tile_lists *lists, const ew_allocator *allocator)
{
    void *const memory[] = {lists->words, lists->pairs, lists->last_pairs};
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; ++i)
        if (memory[i]) allocator->deallocate(allocator->user, memory[i]);
    *lists = (ew_tile_lists){0};
}

/* ---- Pairs ---- */

/* Columns and rows of tiles, the last ones not among them. */
typedef struct tile_box {
    int first[2], end[2];
} tile_box;

/* A source that looks for its tiles. */
typedef struct search {
    ew_tile_lists *lists;
    const ew_allocator *allocator;
    ew_ray_field rays;
    const ew_view *view;
    const ew_interval *depths;
    ew_lit_source source;
    size_t number; /* of sources that have looked */
    ew_list list;
    bool has_range;
    uint8_t piece; /* that looks for its tiles, in steps */
    size_t list_entries;
    tile_box lit; /* by all sources */
    bool is_full; /* there are too many entries */
    bool lacks_memory;
} search;

static size_t row_count(const ew_tile_lists *lists)
{
    return (size_t)lists->columns * (size_t)lists->rows * (size_t)lists->list_rows[EW_LIST_COUNT];
}

static bool is_done(const search *s)
{
    return s->is_full || s->lacks_memory;
}

/* Adds a tile, once a source: several pieces of a chain may find it, in order. */
static void add(search *s, const int tile[2])
{
    ew_tile_lists *lists = s->lists;
    const int tile_row = (tile[1] * lists->columns + tile[0]) * lists->list_rows[EW_LIST_COUNT];
    const uint32_t row = (uint32_t)(tile_row + lists->list_rows[s->list]);
    struct ew_tile_pair *last = lists->last_pairs[row] > 0 ? &lists->pairs[lists->last_pairs[row] - 1] : NULL;
    if (last && last->place == s->source.index) {
        last->last_piece = s->piece;
        return;
    }
    s->list_entries += s->has_range ? 2 : 1;
    s->is_full = row_count(lists) + 1 + s->list_entries > lists->room.most;
    s->lacks_memory = s->lacks_memory || !reserve_pairs(lists, lists->pair_count + 1, s->allocator);
    if (is_done(s)) return;
    lists->pairs[lists->pair_count++] = (struct ew_tile_pair){row, (uint32_t)s->source.index, s->has_range, s->piece, s->piece};
    lists->last_pairs[row] = (uint32_t)lists->pair_count;
    for (int axis = 0; axis < 2; ++axis) {
        s->lit.first[axis] = tile[axis] < s->lit.first[axis] ? tile[axis] : s->lit.first[axis];
        s->lit.end[axis] = tile[axis] >= s->lit.end[axis] ? tile[axis] + 1 : s->lit.end[axis];
    }
}

static ew_cone cone_of(const search *s, const tile_box *box)
{
    const int counts[2] = {s->lists->columns, s->lists->rows};
    double low[2], high[2];
    for (int axis = 0; axis < 2; ++axis) {
        low[axis] = 2.0 * box->first[axis] / counts[axis] - 1;
        high[axis] = 2.0 * box->end[axis] / counts[axis] - 1;
    }
    return ew_cone_of(&s->rays, low, high);
}

static void add_all(search *s, const tile_box *box)
{
    for (int row = box->first[1]; row < box->end[1]; ++row)
        for (int column = box->first[0]; column < box->end[0]; ++column)
            add(s, (const int[2]){column, row});
}

/* Adds the tiles of a box that may be lit by what is around a hull. */
static void add_box(search *s, const ew_hull *seen, const tile_box *box)
{
    const ew_cone cone = cone_of(s, box);
    if (is_done(s) || !ew_cone_meets(&cone, seen, s->source.reach)) return;
    const int width = box->end[0] - box->first[0], height = box->end[1] - box->first[1], axis = height > width;
    if (width * height == 1 || ew_cone_is_covered(&cone, seen, s->source.reach)) {
        add_all(s, box);
        return;
    }
    tile_box half = *box;
    half.end[axis] = box->first[axis] + (axis == 0 ? width : height) / 2;
    add_box(s, seen, &half);
    half.first[axis] = half.end[axis];
    half.end[axis] = box->end[axis];
    add_box(s, seen, &half);
}

/* The tiles from NDC `low` to `high`. */
static void find_tiles(double low, double high, int count, int *first, int *end)
{
    *first = (int)fmax(floor((low * 0.5 + 0.5) * count), 0);
    *end = (int)fmin(floor((high * 0.5 + 0.5) * count) + 1, count);
}

static void add_hull(search *s, const ew_hull *hull)
{
    const ew_hull seen = ew_see_hull(hull, s->view);
    ew_silhouette silhouette;
    tile_box box;
    if (!ew_find_silhouette(&seen, s->source.reach, s->view, s->depths, &silhouette)) return;
    find_tiles(silhouette.low[0], silhouette.high[0], s->lists->columns, &box.first[0], &box.end[0]);
    find_tiles(silhouette.low[1], silhouette.high[1], s->lists->rows, &box.first[1], &box.end[1]);
    if (box.first[0] < box.end[0] && box.first[1] < box.end[1]) add_box(s, &seen, &box);
}

/* Without a reach, it lights every tile. */
static void add_source(search *s)
{
    const size_t hulls = ew_count_hulls(&s->source), step = (hulls + 255) / 256;
    const tile_box everywhere = {{0, 0}, {s->lists->columns, s->lists->rows}};
    for (size_t i = 0; i < hulls && !is_done(s); ++i) {
        const ew_hull hull = ew_hull_of_source(&s->source, i);
        s->piece = (uint8_t)(i / step);
        if (s->source.reach > 0)
            add_hull(s, &hull);
        else
            add_all(s, &everywhere);
    }
}

/* Finds all pairs, unless the search is done before. */
static void find_pairs(search *s, const ew_sources *sources, double light_reach)
{
    ew_tile_lists *lists = s->lists;
    lists->pair_count = 0;
    s->lacks_memory = !reserve_last_pairs(lists, row_count(lists) + 1, s->allocator);
    if (s->lacks_memory) return;
    memset(lists->last_pairs, 0, row_count(lists) * sizeof *lists->last_pairs);
    s->lit = (tile_box){{lists->columns, lists->rows}, {0, 0}};
    while (s->number < sources->lit_count && !is_done(s)) {
        s->source = ew_lit_source_at(sources, s->number++, light_reach);
        s->list = ew_list_of(&s->source);
        s->has_range = lists->path_entries == 2 && ew_is_list_of_paths(s->list);
        add_source(s);
    }
}

/* A list that no source goes into has no row: the next one's stands for its beginning and its end. */
static void lay_out_table(ew_tile_lists *lists, const ew_sources *sources)
{
    lists->list_rows[0] = 0;
    for (int list = 0; list < EW_LIST_COUNT; ++list)
        lists->list_rows[list + 1] = lists->list_rows[list] + sources->has_list[list];
    lists->path_entries = sources->has_list[EW_LIST_POLYLINES] || sources->has_list[EW_LIST_BENDS] ? 2 : 1;
}

/* ---- Entries ---- */

static void set_entry(ew_tile_lists *lists, size_t index, uint32_t value)
{
    const float number = (float)value;
    if (lists->room.is_texture)
        memcpy(&lists->words[index], &number, sizeof number);
    else
        lists->words[index / 2] |= value << 16 * (index % 2);
}

/* In whole units. */
static size_t words_of(size_t entries, bool is_texture)
{
    const size_t words = is_texture ? entries : (entries + 1) / 2, unit = sizeof(ew_vec4) / sizeof(uint32_t);
    return (words + unit - 1) / unit * unit;
}

/* Sorts the pairs by row. Within a row they stay in order. Where each row's next pair goes stands in last_pairs, which is
 * done with. */
static bool fill_entries(ew_tile_lists *lists, size_t list_entries, const ew_allocator *allocator)
{
    const size_t rows = row_count(lists);
    uint32_t *next = lists->last_pairs, at = (uint32_t)rows + 1;
    const size_t count = rows + 1 + list_entries, words = words_of(count, lists->room.is_texture);
    if (!reserve_words(lists, words, allocator)) return false;
    lists->entry_count = count;
    lists->word_count = words;
    memset(lists->words, 0, words * sizeof *lists->words);
    memset(next, 0, rows * sizeof *next);
    for (size_t i = 0; i < lists->pair_count; ++i)
        next[lists->pairs[i].row] += lists->pairs[i].has_range ? 2 : 1;
    for (size_t row = 0; row < rows; ++row) {
        uint32_t length = next[row];
        set_entry(lists, row, at);
        next[row] = at;
        at += length;
    }
    set_entry(lists, rows, at);
    for (size_t i = 0; i < lists->pair_count; ++i) {
        const struct ew_tile_pair *pair = &lists->pairs[i];
        set_entry(lists, next[pair->row]++, pair->place);
        if (pair->has_range) set_entry(lists, next[pair->row]++, pair->first_piece | (uint32_t)pair->last_piece << 8);
    }
    return true;
}

/* ---- All of it ---- */

/* The pixels from tile `first` up to `end` of a viewport that begins at `start` and has `size`. */
static void find_pixels(int first, int end, int size_log2, int start, int size, int *lit_start, int *lit_size)
{
    int low = (first << size_log2) - MARGIN, high = (end << size_log2) - MARGIN;
    low = low > 0 ? low : 0;
    high = high < size ? high : size;
    *lit_start = high > low ? start + low : start;
    *lit_size = high > low ? high - low : 1;
}

static void find_lit_pixels(ew_tile_lists *lists, const tile_box *lit, const ew_viewport *viewport)
{
    const int log2 = lists->size_log2;
    find_pixels(lit->first[0], lit->end[0], log2, viewport->x, viewport->width, &lists->lit.x, &lists->lit.width);
    find_pixels(lit->first[1], lit->end[1], log2, viewport->y, viewport->height, &lists->lit.y, &lists->lit.height);
    lists->first_x = viewport->x - MARGIN;
    lists->first_y = viewport->y - MARGIN;
}

/* The view whose NDC run from -1 to 1 over all tiles. */
static void see_tiles(const ew_view *view, const ew_viewport *viewport, const ew_tile_lists *lists, double projection[16])
{
    const int sizes[2] = {viewport->width, viewport->height}, counts[2] = {lists->columns, lists->rows};
    memcpy(projection, view->projection, 16 * sizeof *projection);
    for (int axis = 0; axis < 2; ++axis) {
        double pixels = (double)counts[axis] * (1 << lists->size_log2);
        double scale = sizes[axis] / pixels, shift = (sizes[axis] + 2.0 * MARGIN) / pixels - 1;
        for (int column = 0; column < 4; ++column)
            projection[4 * column + axis] =
                scale * ew_element(view->projection, axis, column) + shift * ew_element(view->projection, 3, column);
    }
}

static bool has_reach(const ew_sources *sources, double light_reach)
{
    if (light_reach > 0) return true;
    for (size_t i = 0; i < sources->lit_count; ++i)
        if (sources->lit[i].reach > 0) return true;
    return false;
}

/* Where the lists of the frame before needed wider tiles, these will, unless there was much room left. */
static int first_size(const ew_tile_lists *lists)
{
    int last = lists->size_log2 < ONE_TILE_LOG2 ? lists->size_log2 : 0;
    if (lists->entry_count > 0 && lists->entry_count < lists->room.most / 5) --last;
    return last > EW_TILE_SIZE_LOG2 ? last : EW_TILE_SIZE_LOG2;
}

ew_result ew_make_tile_lists(ew_tile_lists *lists, const ew_sources *sources, double light_reach, const ew_view *view,
                             const ew_interval *depths, const ew_viewport *viewport, ew_list_room room,
                             const ew_allocator *allocator, ew_error *error)
{
    int first_size_log2 = has_reach(sources, light_reach) ? first_size(lists) : ONE_TILE_LOG2;
    lists->entry_count = 0;
    lists->room = room;
    if (!is_countable(viewport)) return EW_OK;
    lay_out_table(lists, sources);
    for (int size_log2 = first_size_log2; size_log2 <= ONE_TILE_LOG2; ++size_log2) {
        lists->size_log2 = size_log2;
        lists->columns = tiles_over(viewport->width, size_log2);
        lists->rows = tiles_over(viewport->height, size_log2);
        if (row_count(lists) + 1 > room.most / 2) continue;
        double projection[16];
        see_tiles(view, viewport, lists, projection);
        const ew_view wide = {view->view, projection, view->clip_depth};
        search s = {
            .lists = lists, .allocator = allocator, .rays = ew_make_ray_field(&wide, depths), .view = &wide, .depths = depths};
        find_pairs(&s, sources, light_reach);
        if (!is_done(&s)) s.lacks_memory = !fill_entries(lists, s.list_entries, allocator);
        if (s.lacks_memory)
            return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for the lists of %zu sources", sources->lit_count);
        if (s.is_full) continue;
        find_lit_pixels(lists, &s.lit, viewport);
        return EW_OK;
    }
    return EW_OK;
}
