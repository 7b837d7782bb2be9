/* Lists of sources by tile against places that sources light: where a place is seen, its source is in the list. */
#include "base/allocator.h"
#include "check.h"
#include "lit_scene.h"
#include "plan/plan.h"

#include <limits.h>
#include <stdlib.h>

enum { SIZE = LIT_SCENE_SIZE, SCENES = 40, PLACES = 10000, MARGIN = EW_NODE_MARGIN * EW_CELL_SIZE };

static const ew_list_room block = {.most = 32768}, texture = {.most = 1 << 20, .is_texture = true};

/* The plan of a frame with lists for that room, which belong to the caller, like the sources. */
static ew_plan plan_of(const ew_sources_desc *desc, const ew_frame_desc *frame, ew_list_room room, ew_sources *sources,
                       ew_tile_lists *lists)
{
    ew_plan plan = {0};
    ew_error error = {EW_OK, ""};
    if (ew_sources_set(sources, desc, &ew_default_allocator, &error) != EW_OK ||
        ew_plan_frame(&plan, sources, NULL, frame, &error) != EW_OK ||
        ew_plan_lists(&plan, lists, sources, frame, room, &ew_default_allocator, &error) != EW_OK)
        fail_msg("%s", error.text);
    return plan;
}

static void release(ew_sources *sources, ew_tile_lists *lists)
{
    ew_sources_destroy(sources, &ew_default_allocator);
    ew_destroy_tile_lists(lists, &ew_default_allocator);
}

/* As glsl/light/list.glsl does. */
static size_t entry(const ew_tile_lists *lists, size_t i)
{
    float number;
    if (!lists->room.is_texture) return lists->words[i / 2] >> 16 * (i % 2) & 0xffff;
    memcpy(&number, &lists->words[i], sizeof number);
    return (size_t)number;
}

static size_t first_row(const ew_plan *plan, double x, double y)
{
    const ew_ivec4 *tiles = &plan->uniforms.grid.tiles;
    int column = ((int)floor(x) - plan->lit.x - tiles->z) >> tiles->y;
    int row = ((int)floor(y) - plan->lit.y - tiles->w) >> tiles->y;
    return (size_t)(row * tiles->x + column) * (size_t)plan->uniforms.list_rows[EW_LIST_COUNT];
}

static bool is_listed(const ew_plan *plan, size_t row, ew_list list, size_t place)
{
    const ew_tile_lists *lists = plan->lists;
    const int *rows = plan->uniforms.list_rows;
    const size_t step = ew_is_list_of_paths(list) ? (size_t)lists->path_entries : 1;
    for (size_t i = entry(lists, row + (size_t)rows[list]); i < entry(lists, row + (size_t)rows[list + 1]); i += step)
        if (entry(lists, i) == place) return true;
    return false;
}

/* The pieces, of the only source, that the lists of a tile have; none is a last one below the first. */
typedef struct listed_pieces {
    size_t first, last;
} listed_pieces;

static listed_pieces pieces_in(const ew_plan *plan, size_t row, const ew_lit_source *source)
{
    const ew_tile_lists *lists = plan->lists;
    const int *rows = plan->uniforms.list_rows;
    const ew_list list = ew_list_of(source);
    const size_t count = source->pieces->piece_count, step = (count + 255) / 256;
    const size_t at = entry(lists, row + (size_t)rows[list]);
    if (at == entry(lists, row + (size_t)rows[list + 1])) return (listed_pieces){1, 0};
    const size_t range = entry(lists, at + 1), last = ((range >> 8) + 1) * step - 1;
    return (listed_pieces){(range & 255) * step, last < count ? last : count - 1};
}

/* How many tiles list some source. */
static size_t count_lit_tiles(const ew_tile_lists *lists)
{
    const size_t step = (size_t)lists->list_rows[EW_LIST_COUNT];
    size_t count = 0, rows = (size_t)(lists->columns * lists->rows) * step;
    for (size_t row = 0; row < rows; row += step)
        count += entry(lists, row) < entry(lists, row + step);
    return count;
}

static bool is_in_viewport(const double seen[3])
{
    return fabs(seen[0]) < 1 && fabs(seen[1]) < 1;
}

/* In the viewport, and as far around it as nodes lie. */
static void what_lights_a_place_is_in_the_list_of_its_tile(void **state)
{
    uint64_t random = 3;
    (void)state;
    for (int k = 0; k < SOURCE_KIND_COUNT; ++k) {
        const source_kind *kind = source_kinds[k];
        int visible = 0;
        for (int number = 0; number < SCENES; ++number) {
            lit_scene made;
            lit_scene_make(&made, kind, &random);
            made.frame.core_pixels = 0; /* or light pales far away */
            ew_sources sources = {0};
            ew_tile_lists lists = {0};
            const ew_plan plan = plan_of(&made.desc, &made.frame, block, &sources, &lists);
            for (int i = 0; i < PLACES; ++i) {
                double place[3], seen[3];
                lit_scene_place(&made, kind, &random, place);
                if (!lit_scene_project(&made.frame, place, seen)) continue;
                double x = (0.5 * seen[0] + 0.5) * SIZE, y = (0.5 * seen[1] + 0.5) * SIZE;
                if (!(x >= -MARGIN && x < SIZE + MARGIN && y >= -MARGIN && y < SIZE + MARGIN)) continue;
                ++visible;
                if (!is_listed(&plan, first_row(&plan, x, y), ew_list_of(&sources.lit[0]), 0))
                    fail_msg("%s, scene %d: (%g, %g) is lit at depth %g of %g to %g", kind->name, number, x, y, seen[2],
                             plan.depths.start, plan.depths.end);
                const ew_viewport *lit = &plan.lit;
                if (is_in_viewport(seen) && (x < lit->x || x > lit->x + lit->width || y < lit->y || y > lit->y + lit->height))
                    fail_msg("%s, scene %d: (%g, %g) is lit, and not drawn", kind->name, number, x, y);
            }
            release(&sources, &lists);
        }
        assert_true(visible > SCENES * PLACES / 20);
    }
}

/* A beam from corner to corner lights a band. Its rectangle is the whole viewport. */
static void a_slanted_beam_is_not_listed_in_all_of_its_rectangle(void **state)
{
    (void)state;
    const double ends[2][3] = {{-5, -5, -5}, {5, 5, -5}};
    const ew_path beam = {.points = ends, .point_count = 2, .coefficient = 1, .core = 1e-3, .reach = 0.1};
    const ew_sources_desc desc = {.paths = &beam, .path_count = 1, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists lists = {0};
    plan_of(&desc, &frame, block, &sources, &lists);
    /* 1000 / 32 tiles on the diagonal; on average the band, 28 pixels wide, meets three of each column or fewer. */
    assert_in_range(count_lit_tiles(&lists), 32, 4 * 32);
    release(&sources, &lists);
}

static void light_behind_the_eye_is_in_no_list(void **state)
{
    (void)state;
    const ew_point orbs[] = {{.position = {0, 0, 3}, .coefficient = 1, .core = 1e-3, .reach = 1},
                             {.position = {30, 0, -5}, .coefficient = 1, .core = 1e-3, .reach = 1}};
    const ew_sources_desc desc = {.points = orbs, .point_count = 2, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists lists = {0};
    const ew_plan plan = plan_of(&desc, &frame, block, &sources, &lists);
    assert_int_equal(count_lit_tiles(&lists), 0);
    assert_int_equal(plan.lit.width * plan.lit.height, 1);
    release(&sources, &lists);
}

static void lists_keep_the_order_of_the_sources(void **state)
{
    (void)state;
    ew_point orbs[40];
    ew_line lines[2];
    for (int i = 0; i < 40; ++i)
        orbs[i] = (ew_point){.position = {0.1 * i - 2, 0, -5}, .coefficient = 1, .core = 1e-3, .reach = 1};
    for (int i = 0; i < 2; ++i)
        lines[i] = (ew_line){.position = {0, 0, -5}, .direction = {1, i, 0}, .coefficient = 1, .core = 1e-3, .reach = 1};
    const ew_sources_desc desc = {.points = orbs, .point_count = 40, .lines = lines, .line_count = 2, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists lists = {0};
    const ew_plan plan = plan_of(&desc, &frame, block, &sources, &lists);
    const size_t row = first_row(&plan, SIZE / 2, SIZE / 2), first = entry(&lists, row), end = entry(&lists, row + 1);
    assert_in_range(end - first, 10, 39);
    for (size_t i = first + 1; i < end; ++i)
        assert_int_equal(entry(&lists, i), entry(&lists, i - 1) + 1);
    assert_int_equal(entry(&lists, row + 2) - end, 2);
    assert_int_equal(entry(&lists, end), 0);
    assert_int_equal(entry(&lists, end + 1), 1);
    release(&sources, &lists);
}

/* They are integrated in different ways, and a list that no source goes into takes no room. */
static void paths_of_each_form_have_lists_of_their_own(void **state)
{
    (void)state;
    const double places[][3] = {{-1, 0, -5}, {0, 1, -5}, {1, 0, -5}};
    const ew_path light = {.points = places, .coefficient = 1, .core = 1e-3, .reach = 0.1};
    ew_path paths[] = {light, light, light, light};
    paths[0].kind = EW_PATH_CATMULL_ROM;
    paths[0].point_count = 3;
    paths[1].point_count = 2;
    paths[2].point_count = 3;
    paths[3].point_count = 2;
    const ew_list expected[] = {EW_LIST_BENDS, EW_LIST_BEAMS, EW_LIST_POLYLINES, EW_LIST_BEAMS};
    const ew_sources_desc desc = {.paths = paths, .path_count = 4, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists lists = {0};
    const ew_plan plan = plan_of(&desc, &frame, block, &sources, &lists);
    const double x = SIZE / 2 * (1 - 1.0 / 5);
    const size_t row = first_row(&plan, x, SIZE / 2);
    assert_int_equal(lists.list_rows[EW_LIST_COUNT], 3);
    for (size_t i = 0; i < 4; ++i)
        for (int list = 0; list < EW_LIST_COUNT; ++list)
            assert_int_equal(is_listed(&plan, row, (ew_list)list, i), list == (int)expected[i]);
    release(&sources, &lists);
}

/* A spring of many pieces along the viewport, of which a tile sees a few. */
static void a_tile_lists_the_pieces_that_light_it_and_few_others(void **state)
{
    (void)state;
    enum { POINTS = 501 };
    static double points[POINTS][3];
    for (int i = 0; i < POINTS; ++i) {
        points[i][0] = 9.0 * i / (POINTS - 1) - 4.5;
        points[i][1] = 0.2 * sin(0.7 * i);
        points[i][2] = -5 + 0.2 * cos(0.7 * i);
    }
    const ew_path spring = {
        .points = (const double(*)[3])points, .point_count = POINTS, .coefficient = 1, .core = 1e-3, .reach = 0.1};
    const ew_sources_desc desc = {.paths = &spring, .path_count = 1, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists lists = {0};
    const ew_plan plan = plan_of(&desc, &frame, block, &sources, &lists);
    assert_int_equal(sources.lit[0].pieces->piece_count, POINTS - 1);
    size_t listed = 0;
    for (int i = 0; i + 1 < POINTS; ++i) {
        const double middle[3] = {0.5 * (points[i][0] + points[i + 1][0]), 0.5 * (points[i][1] + points[i + 1][1]),
                                  0.5 * (points[i][2] + points[i + 1][2])};
        double seen[3];
        assert_true(lit_scene_project(&frame, middle, seen));
        const size_t row = first_row(&plan, (0.5 * seen[0] + 0.5) * SIZE, (0.5 * seen[1] + 0.5) * SIZE);
        const listed_pieces pieces = pieces_in(&plan, row, &sources.lit[0]);
        assert_in_range(i, pieces.first, pieces.last);
        listed += pieces.last - pieces.first + 1;
    }
    assert_true(listed < 60 * (POINTS - 1));
    release(&sources, &lists);
}

/* Down to a tile for all, and then none. */
static void tiles_are_wider_where_there_is_less_room(void **state)
{
    (void)state;
    ew_point orbs[100];
    for (int i = 0; i < 100; ++i)
        orbs[i] = (ew_point){.position = {0.1 * (i % 10), 0.1 * (i / 10), -5}, .coefficient = 1, .core = 1e-3, .reach = 3};
    const ew_sources_desc desc = {.points = orbs, .point_count = 100, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists lists = {0};
    int previous = 0;
    const size_t rooms[] = {1 << 20, 32768, 8192, 2048, 1 + 1 + 100};
    for (int i = 0; i < 5; ++i) {
        const ew_plan plan = plan_of(&desc, &frame, (ew_list_room){.most = rooms[i]}, &sources, &lists);
        assert_in_range(lists.entry_count, 1, rooms[i]);
        assert_true(lists.size_log2 >= previous);
        previous = lists.size_log2;
        assert_true(is_listed(&plan, first_row(&plan, SIZE / 2, SIZE / 2), EW_LIST_POINTS, 0));
        assert_true(plan.permutation & EW_PERMUTATION_LISTS);
    }
    assert_int_equal(lists.columns * lists.rows, 1);
    const ew_plan plan = plan_of(&desc, &frame, (ew_list_room){.most = 1 + 100}, &sources, &lists);
    assert_false(plan.permutation & EW_PERMUTATION_LISTS);
    assert_null(plan.lists);
    release(&sources, &lists);
}

/* An allocator that grants so many blocks. */
typedef struct few_blocks {
    int allowed, held;
    bool has_refused;
} few_blocks;

static void *allocate_few(void *user, size_t size)
{
    few_blocks *few = user;
    few->has_refused = few->has_refused || few->allowed == 0;
    if (few->allowed == 0) return NULL;
    few->allowed--;
    few->held++;
    return malloc(size);
}

static void deallocate_few(void *user, void *memory)
{
    ((few_blocks *)user)->held--;
    free(memory);
}

/* Which has room for more. */
static void a_texture_gets_the_lists_of_a_block(void **state)
{
    (void)state;
    const ew_point orbs[] = {{.position = {1, 0, -5}, .coefficient = 1, .core = 1e-3, .reach = 1},
                             {.position = {-1, 2, -6}, .coefficient = 1, .core = 1e-3, .reach = 2}};
    const ew_sources_desc desc = {.points = orbs, .point_count = 2, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_tile_lists of_block = {0}, of_texture = {0};
    plan_of(&desc, &frame, block, &sources, &of_block);
    const ew_plan plan = plan_of(&desc, &frame, texture, &sources, &of_texture);
    assert_int_equal(of_block.entry_count, of_texture.entry_count);
    for (size_t i = 0; i < of_block.entry_count; ++i)
        assert_int_equal(entry(&of_block, i), entry(&of_texture, i));
    assert_int_equal(ew_first_list_row(&plan), 1);
    release(&sources, &of_block);
    ew_destroy_tile_lists(&of_texture, &ew_default_allocator);
}

/* A context will refuse it. */
static void a_viewport_beyond_all_limits_has_no_lists(void **state)
{
    (void)state;
    const ew_point orb = {.position = {0, 0, -5}, .coefficient = 1, .core = 1e-3, .reach = 1};
    const ew_sources_desc desc = {.points = &orb, .point_count = 1, .epsilon = 1};
    static const int viewports[][4] = {{0, 0, INT_MAX, 1}, {0, 0, 1, INT_MAX}, {INT_MAX, 0, 1, 1}, {0, INT_MIN, 1, 1}};
    for (int i = 0; i < 4; ++i) {
        ew_frame_desc frame = lit_scene_plain_frame();
        frame.viewport_x = viewports[i][0];
        frame.viewport_y = viewports[i][1];
        frame.viewport_width = viewports[i][2];
        frame.viewport_height = viewports[i][3];
        ew_sources sources = {0};
        ew_tile_lists lists = {0};
        assert_null(plan_of(&desc, &frame, block, &sources, &lists).lists);
        release(&sources, &lists);
    }
}

static void memory_that_is_exhausted_is_an_error(void **state)
{
    (void)state;
    const ew_point orb = {.position = {0, 0, -5}, .coefficient = 1, .core = 1e-3, .reach = 1};
    const ew_sources_desc desc = {.points = &orb, .point_count = 1, .epsilon = 1};
    const ew_frame_desc frame = lit_scene_plain_frame();
    ew_sources sources = {0};
    ew_plan plan;
    ew_error error;
    assert_int_equal(ew_sources_set(&sources, &desc, &ew_default_allocator, NULL), EW_OK);
    for (int allowed = 0; allowed < 4; ++allowed) {
        ew_tile_lists lists = {0};
        few_blocks few = {.allowed = allowed};
        const ew_allocator allocator = {allocate_few, deallocate_few, &few};
        assert_int_equal(ew_plan_frame(&plan, &sources, NULL, &frame, NULL), EW_OK);
        ew_result result = ew_plan_lists(&plan, &lists, &sources, &frame, block, &allocator, &error);
        if (few.has_refused)
            check_refused(result, &error, EW_ERROR_OUT_OF_MEMORY, "no memory");
        else
            assert_int_equal(result, EW_OK);
        ew_destroy_tile_lists(&lists, &allocator);
        assert_int_equal(few.held, 0);
    }
    ew_sources_destroy(&sources, &ew_default_allocator);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_lights_a_place_is_in_the_list_of_its_tile),
        cmocka_unit_test(a_slanted_beam_is_not_listed_in_all_of_its_rectangle),
        cmocka_unit_test(light_behind_the_eye_is_in_no_list),
        cmocka_unit_test(lists_keep_the_order_of_the_sources),
        cmocka_unit_test(paths_of_each_form_have_lists_of_their_own),
        cmocka_unit_test(a_tile_lists_the_pieces_that_light_it_and_few_others),
        cmocka_unit_test(tiles_are_wider_where_there_is_less_room),
        cmocka_unit_test(a_texture_gets_the_lists_of_a_block),
        cmocka_unit_test(a_viewport_beyond_all_limits_has_no_lists),
        cmocka_unit_test(memory_that_is_exhausted_is_an_error),
    };
    return cmocka_run_group_tests_name("tile_lists", tests, NULL, NULL);
}
