/* Keys of permutations: which frames share a shader, and which shader can stand in for another. */
#include "check.h"
#include "plan/permutation.h"

#include <string.h>

static const ew_frame_desc defaults = EW_FRAME_DEFAULTS;

static void one_source_is_exact_and_more_are_any(void **state)
{
    (void)state;
    for (size_t count = 0; count < 8; ++count) {
        ew_mix mix = {0};
        for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
            memcpy((char *)&mix + ew_kinds[kind]->mix_offset, &count, sizeof count);
        ew_key key = ew_permutation_of(&mix, &defaults);
        for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
            assert_int_equal(ew_permutation_count(key, kind), count <= 1 ? count : EW_ANY_COUNT);
    }
}

static void weights_count_only_where_a_kind_takes_them(void **state)
{
    (void)state;
    const ew_mix points = {.point_count = 2, .has_weights = 1}, curves = {.curve_count = 2, .has_weights = 1};
    assert_false(ew_permutation_of(&points, &defaults) & EW_PERMUTATION_WEIGHTS);
    assert_true(ew_permutation_of(&curves, &defaults) & EW_PERMUTATION_WEIGHTS);
}

static void dither_is_for_pictures_of_few_bits_alone(void **state)
{
    (void)state;
    const ew_mix mix = {.point_count = 1};
    ew_frame_desc frame = defaults;
    frame.dither = 1;
    assert_true(ew_permutation_of(&mix, &frame) & EW_PERMUTATION_DITHER);
    frame.encoding = EW_ENCODING_SRGB_8BIT;
    assert_true(ew_permutation_of(&mix, &frame) & EW_PERMUTATION_DITHER_SRGB);
    frame.encoding = EW_ENCODING_FLOAT;
    assert_false(ew_permutation_of(&mix, &frame) & EW_PERMUTATION_DITHER);
    static const ew_encoding few_bits[] = {EW_ENCODING_LINEAR_8BIT, EW_ENCODING_LINEAR_10BIT, EW_ENCODING_FLOAT_11BIT};
    for (int i = 0; i < 3; ++i) {
        frame.encoding = few_bits[i];
        assert_true(ew_permutation_of(&mix, &frame) & EW_PERMUTATION_DITHER);
        assert_false(ew_permutation_of(&mix, &frame) & EW_PERMUTATION_DITHER_SRGB);
    }
    frame.output = EW_OUTPUT_LUMINANCE;
    assert_false(ew_permutation_of(&mix, &frame) & EW_PERMUTATION_DITHER);
}

static void a_general_shader_covers_what_it_is_general_for(void **state)
{
    (void)state;
    const ew_mix one_curve = {.curve_count = 1}, weighted = {.curve_count = 1, .has_weights = 1};
    const ew_mix any_curves = {.curve_count = EW_ANY_COUNT, .has_weights = 1}, any_points = {.point_count = EW_ANY_COUNT};
    ew_key any = ew_permutation_of(&any_curves, &defaults), one = ew_permutation_of(&one_curve, &defaults);
    assert_true(ew_permutation_covers(any, one));
    assert_true(ew_permutation_covers(any, ew_permutation_of(&weighted, &defaults)));
    assert_true(ew_permutation_covers(one, one));
    assert_false(ew_permutation_covers(one, any));
    assert_false(ew_permutation_covers(one, ew_permutation_of(&weighted, &defaults)));
    assert_false(ew_permutation_covers(ew_permutation_of(&any_points, &defaults), one));
    assert_false(ew_permutation_covers(ew_permutation_with_depth(any, EW_DEPTH_KIND_SINGLE), one));
}

/* Otherwise a source that comes or goes would make the driver compile. */
static void with_reaches_the_same_shader_draws_any_count(void **state)
{
    (void)state;
    const ew_mix beam = {.path_count = 1}, beams = {.path_count = 100};
    const ew_key one = ew_permutation_of(&beam, &defaults), many = ew_permutation_of(&beams, &defaults);
    assert_true(one != many);
    assert_int_equal(ew_permutation_with_lists(one), ew_permutation_with_lists(many));
    assert_int_equal(ew_permutation_count(ew_permutation_with_lists(one), 0), 0);
    const ew_frame_desc papers = {.interval_start = 1, .interval_end = 2};
    ew_key without_reach = ew_permutation_of(&beam, &papers);
    assert_int_equal(ew_permutation_with_lists(without_reach), without_reach);
}

static void the_world_integral_has_reaches_and_cores_as_wide_as_pixels(void **state)
{
    (void)state;
    const ew_mix point = {.point_count = 1};
    ew_frame_desc frame = defaults;
    ew_key world = ew_permutation_of(&point, &frame);
    assert_true(world & EW_PERMUTATION_WORLD && world & EW_PERMUTATION_REACH && world & EW_PERMUTATION_CORE_PIXELS);
    frame.core_pixels = 0;
    assert_false(ew_permutation_of(&point, &frame) & EW_PERMUTATION_CORE_PIXELS);
    frame.interval_start = 1;
    frame.interval_end = 2;
    const unsigned field = EW_PERMUTATION_WORLD | EW_PERMUTATION_REACH | EW_PERMUTATION_SHARPNESS | EW_PERMUTATION_CORE_PIXELS |
                           EW_PERMUTATION_BENDS;
    assert_false(ew_permutation_of(&point, &frame) & field);
    frame.core_pixels = 1;
    assert_true(ew_permutation_of(&point, &frame) & EW_PERMUTATION_CORE_PIXELS);
}

static void fog_counts_only_where_there_is_some(void **state)
{
    (void)state;
    const ew_mix point = {.point_count = 1};
    const unsigned fogs = EW_PERMUTATION_FOG | EW_PERMUTATION_FOG_HEIGHT;
    ew_frame_desc frame = defaults;
    frame.fog.scale = 3;
    ew_key clear = ew_permutation_of(&point, &frame);
    assert_int_equal(clear & fogs, 0);
    frame.fog.extinction = 0.1;
    ew_key by_height = ew_permutation_of(&point, &frame);
    assert_int_equal(by_height & fogs, fogs);
    frame.fog.scale = 0;
    ew_key even = ew_permutation_of(&point, &frame);
    assert_int_equal(even & fogs, EW_PERMUTATION_FOG);
    assert_false(ew_permutation_covers(even, clear) || ew_permutation_covers(clear, even));
    assert_false(ew_permutation_covers(even, by_height) || ew_permutation_covers(by_height, even));
}

static void media_are_seen_in_pictures_and_dim_all_that_is_measured(void **state)
{
    (void)state;
    static const ew_output outputs[] = {EW_OUTPUT_LERP, EW_OUTPUT_LUMINANCE, EW_OUTPUT_EVALUATIONS};
    const ew_mix point = {.point_count = 1};
    const ew_medium medium = {.extinction = 0};
    ew_frame_desc frame = defaults;
    frame.media = &medium;
    for (int i = 0; i < 3; ++i) {
        frame.output = outputs[i];
        frame.medium_count = 1;
        const ew_key media = EW_PERMUTATION_FOG | EW_PERMUTATION_MEDIA;
        assert_true((ew_permutation_of(&point, &frame) & media) == media);
        frame.medium_count = 0;
        assert_false(ew_permutation_of(&point, &frame) & media);
    }
    frame.output = EW_OUTPUT_SURFACES;
    frame.light_reach = 1;
    frame.medium_count = 1;
    assert_false(ew_permutation_of(&point, &frame) & EW_PERMUTATION_MEDIA);
}

static const ew_mix all_kinds = {
    .point_count = 3, .line_count = 3, .torus_count = 3, .curve_count = 3, .path_count = 3, .has_weights = 1, .has_bends = 1};

/* Or its light would be added twice, or not at all. */
static void every_source_is_of_one_part(void **state)
{
    (void)state;
    const ew_key all = ew_permutation_of(&all_kinds, &defaults);
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        ew_key forms = 0;
        int part_count = 0;
        for (int part = 0; part < EW_PART_COUNT; ++part) {
            const ew_key key = ew_permutation_of_part(all, (ew_part)part);
            if (ew_permutation_count(key, kind) == 0) continue;
            assert_true(ew_permutation_has_part(all, (ew_part)part));
            assert_true(key & EW_PERMUTATION_PART);
            assert_int_equal(key & EW_PERMUTATION_FORMS & forms, 0);
            forms |= key & EW_PERMUTATION_FORMS;
            part_count++;
        }
        assert_int_equal(part_count, ew_kinds[kind]->chain ? 3 : 1);
        if (ew_kinds[kind]->chain) assert_int_equal(forms, EW_PERMUTATION_FORMS);
    }
}

/* Or a cell that a list of the part lights would not be drawn, or one that none of them does. */
static void the_lists_of_a_part_are_neighbours_and_no_other_part_has_them(void **state)
{
    (void)state;
    const ew_key all = ew_permutation_of(&all_kinds, &defaults);
    int parts_with[EW_LIST_COUNT] = {0};
    for (int part = 0; part < EW_PART_COUNT; ++part) {
        const ew_list_range lists = ew_permutation_lists(ew_permutation_of_part(all, (ew_part)part));
        for (int list = lists.first; list < lists.last; ++list)
            parts_with[list]++;
    }
    for (int list = 0; list < EW_LIST_COUNT; ++list)
        assert_int_equal(parts_with[list], 1);
    const ew_list_range whole = ew_permutation_lists(all);
    assert_int_equal(whole.first, 0);
    assert_int_equal(whole.last, EW_LIST_COUNT);
}

/* A shader for one form of paths leaves out the others. */
static void no_part_covers_another(void **state)
{
    (void)state;
    const ew_key all = ew_permutation_of(&all_kinds, &defaults);
    for (int part = 0; part < EW_PART_COUNT; ++part)
        for (int other = 0; other < EW_PART_COUNT; ++other)
            assert_int_equal(
                ew_permutation_covers(ew_permutation_of_part(all, (ew_part)part), ew_permutation_of_part(all, (ew_part)other)),
                part == other);
    const ew_mix beams = {.path_count = 1}, bends = {.path_count = 2, .has_bends = 1};
    const ew_key straight = ew_permutation_of_part(ew_permutation_of(&beams, &defaults), EW_PART_STRAIGHT);
    const ew_key bent = ew_permutation_of_part(ew_permutation_of(&bends, &defaults), EW_PART_BENDS);
    assert_false(ew_permutation_covers(bent, straight) || ew_permutation_covers(straight, bent));
}

static void what_is_long_is_split_where_light_can_be_summed_up(void **state)
{
    (void)state;
    static const struct {
        ew_mix mix;
        bool is_split, is_split_in_fog;
    } cases[] = {
        {{.point_count = 0}, false, false},
        {{.point_count = 9, .line_count = 9}, false, false},
        {{.point_count = 1, .torus_count = 1}, false, true},
        {{.curve_count = 9}, false, false},
        {{.point_count = 1, .curve_count = 1}, true, true},
        {{.path_count = 9}, false, false},
        {{.path_count = 9, .has_joints = 1}, false, true},
        {{.path_count = 9, .has_bends = 1}, false, true},
        {{.point_count = 1, .path_count = 1, .has_bends = 1}, true, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        const ew_key key = ew_permutation_of(&cases[i].mix, &defaults);
        assert_int_equal(ew_permutation_is_split(key), cases[i].is_split);
        assert_int_equal(ew_permutation_is_split(key | EW_PERMUTATION_FOG), cases[i].is_split_in_fog);
    }
    ew_frame_desc frame = defaults;
    const ew_key all = ew_permutation_of(&all_kinds, &frame);
    assert_true(ew_permutation_is_split(all));
    assert_false(ew_permutation_is_split(ew_permutation_with_depth(all, EW_DEPTH_KIND_MULTISAMPLE)));
    frame.output = EW_OUTPUT_EVALUATIONS;
    const ew_key counts = ew_permutation_of(&all_kinds, &frame);
    assert_true(ew_permutation_is_split(counts));
    assert_true(ew_permutation_summed(counts) & EW_PERMUTATION_EVALUATIONS);
    frame = defaults;
    frame.integrator = EW_INTEGRATOR_SIMPSON;
    assert_false(ew_permutation_is_split(ew_permutation_of(&all_kinds, &frame)));
}

static void bends_count_only_where_there_are_paths(void **state)
{
    (void)state;
    const ew_mix curves = {.curve_count = 2, .has_bends = 1}, paths = {.path_count = 2, .has_bends = 1};
    assert_false(ew_permutation_of(&curves, &defaults) & EW_PERMUTATION_BENDS);
    assert_true(ew_permutation_of(&paths, &defaults) & EW_PERMUTATION_BENDS);
}

/* Their blocks have other sizes. */
static void shaders_with_and_without_reaches_do_not_cover_each_other(void **state)
{
    (void)state;
    const ew_mix plain = {.point_count = 1}, reaching = {.point_count = 1, .has_reach = 1};
    const ew_mix sharp = {.point_count = 1, .has_reach = 1, .has_sharpness = 1};
    ew_frame_desc frame = defaults;
    frame.interval_start = 1;
    frame.interval_end = 2;
    ew_key plain_key = ew_permutation_of(&plain, &frame), reaching_key = ew_permutation_of(&reaching, &frame);
    assert_false(ew_permutation_covers(reaching_key, plain_key));
    assert_false(ew_permutation_covers(plain_key, reaching_key));
    assert_true(ew_permutation_covers(ew_permutation_of(&sharp, &frame), reaching_key));
    assert_false(ew_permutation_covers(ew_permutation_of(&reaching, &defaults), reaching_key)); /* another integral */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_source_is_exact_and_more_are_any),
        cmocka_unit_test(weights_count_only_where_a_kind_takes_them),
        cmocka_unit_test(dither_is_for_pictures_of_few_bits_alone),
        cmocka_unit_test(a_general_shader_covers_what_it_is_general_for),
        cmocka_unit_test(with_reaches_the_same_shader_draws_any_count),
        cmocka_unit_test(the_world_integral_has_reaches_and_cores_as_wide_as_pixels),
        cmocka_unit_test(fog_counts_only_where_there_is_some),
        cmocka_unit_test(media_are_seen_in_pictures_and_dim_all_that_is_measured),
        cmocka_unit_test(every_source_is_of_one_part),
        cmocka_unit_test(the_lists_of_a_part_are_neighbours_and_no_other_part_has_them),
        cmocka_unit_test(no_part_covers_another),
        cmocka_unit_test(what_is_long_is_split_where_light_can_be_summed_up),
        cmocka_unit_test(bends_count_only_where_there_are_paths),
        cmocka_unit_test(shaders_with_and_without_reaches_do_not_cover_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
