/* Rays and window depths of every kind of projection, against the full matrix and its inverse. */
#include "check.h"
#include "plan/plan.h"

#include <stdbool.h>

enum { X = 40, Y = 25, WIDTH = 640, HEIGHT = 360 }; /* the viewport */

typedef struct camera {
    const char *name;
    double projection[16];
    ew_clip_depth clip_depth;
    double start, end; /* the interval */
} camera;

/* ---- Projections, column-major, from the books ---- */

/* glFrustum's matrix. */
static void frustum(double m[16], double left, double right, double bottom, double top, double near_depth, double far_depth)
{
    memset(m, 0, 16 * sizeof *m);
    m[0] = 2 * near_depth / (right - left);
    m[5] = 2 * near_depth / (top - bottom);
    m[8] = (right + left) / (right - left);
    m[9] = (top + bottom) / (top - bottom);
    m[10] = -(far_depth + near_depth) / (far_depth - near_depth);
    m[11] = -1;
    m[14] = -2 * far_depth * near_depth / (far_depth - near_depth);
}

/* glOrtho's matrix. */
static void orthographic(double m[16], double left, double right, double bottom, double top, double near_depth,
                         double far_depth)
{
    memset(m, 0, 16 * sizeof *m);
    m[0] = 2 / (right - left);
    m[5] = 2 / (top - bottom);
    m[10] = -2 / (far_depth - near_depth);
    m[12] = -(right + left) / (right - left);
    m[13] = -(top + bottom) / (top - bottom);
    m[14] = -(far_depth + near_depth) / (far_depth - near_depth);
    m[15] = 1;
}

/* Lengyel's oblique near plane: the plane's points get NDC depth -1, so that it clips what is before it. */
static void clip_obliquely(double m[16], const double plane[4])
{
    double x = ((plane[0] > 0 ? 1 : -1) + m[8]) / m[0], y = ((plane[1] > 0 ? 1 : -1) + m[9]) / m[5];
    double w = (1 + m[10]) / m[14];
    double scale = 2 / (plane[0] * x + plane[1] * y - plane[2] + plane[3] * w);
    m[2] = plane[0] * scale;
    m[6] = plane[1] * scale;
    m[10] = plane[2] * scale + 1;
    m[14] = plane[3] * scale;
}

enum { CAMERA_COUNT = 13 };

/* Each of these makes the cameras from `c` on and returns the last. Until they change it, each camera is a perspective one with
 * the near and far planes at n and f, and half_width and half_height are what it sees at the near plane. */
static const double n = 0.1, f = 1000, half_width = 0.08, half_height = 0.045;

static camera *make_perspective_cameras(camera *c)
{
    c->name = "perspective";

    (++c)->name = "perspective, interval from near to far";
    c->start = n;
    c->end = f;

    (++c)->name = "off-axis perspective";
    frustum(c->projection, -0.5 * half_width, 1.7 * half_width, -2 * half_height, 0.1 * half_height, n, f);

    (++c)->name = "jittered perspective, turned upside down";
    c->projection[8] += 0.3 / WIDTH;
    c->projection[9] -= 0.4 / HEIGHT;
    c->projection[5] = -c->projection[5];

    (++c)->name = "perspective on a display turned by 90 degrees, scaled by 3";
    c->projection[1] = c->projection[0];
    c->projection[4] = -c->projection[5];
    c->projection[0] = c->projection[5] = 0;
    for (int i = 0; i < 16; ++i)
        c->projection[i] *= 3;

    return c;
}

static camera *make_cameras_of_other_depths(camera *c)
{
    c->name = "perspective, [0, 1]";
    c->clip_depth = EW_CLIP_DEPTH_ZERO_TO_ONE;
    c->projection[10] = -f / (f - n);
    c->projection[14] = -f * n / (f - n);

    (++c)->name = "reversed-Z, [0, 1]";
    c->clip_depth = EW_CLIP_DEPTH_ZERO_TO_ONE;
    c->projection[10] = n / (f - n);
    c->projection[14] = f * n / (f - n);

    (++c)->name = "reversed-Z, infinite, [0, 1]";
    c->clip_depth = EW_CLIP_DEPTH_ZERO_TO_ONE;
    c->projection[10] = 0;
    c->projection[14] = n;
    c->end = 3e4;

    (++c)->name = "infinite";
    c->projection[10] = -1;
    c->projection[14] = -2 * n;
    c->end = 3e4;

    (++c)->name = "oblique near plane";
    clip_obliquely(c->projection, (double[4]){0.3, -0.2, -0.9, -1});

    return c;
}

static camera *make_parallel_cameras(camera *c)
{
    c->name = "orthographic, from behind the eye";
    orthographic(c->projection, -8, 8, -4.5, 4.5, -10, 100);
    c->start = -5;

    (++c)->name = "orthographic, off-centre, reversed-Z, [0, 1]";
    orthographic(c->projection, 2, 18, -9, 0, 1, 100);
    c->clip_depth = EW_CLIP_DEPTH_ZERO_TO_ONE;
    c->projection[10] = 1 / 99.0;
    c->projection[14] = 100 / 99.0;

    (++c)->name = "oblique parallel (cabinet)";
    orthographic(c->projection, -8, 8, -4.5, 4.5, 1, 100);
    c->projection[8] = 0.04;
    c->projection[9] = -0.03;

    return c;
}

static void make_cameras(camera cameras[CAMERA_COUNT])
{
    for (int i = 0; i < CAMERA_COUNT; ++i) {
        cameras[i] = (camera){.start = 3, .end = 15};
        frustum(cameras[i].projection, -half_width, half_width, -half_height, half_height, n, f);
    }
    camera *last = make_perspective_cameras(cameras);
    last = make_cameras_of_other_depths(last + 1);
    last = make_parallel_cameras(last + 1);
    assert_ptr_equal(last, &cameras[CAMERA_COUNT - 1]);
}

/* ---- The same by full matrices ---- */

/* Solves m x = b by elimination with pivots. */
static void solve(const double m[16], const double b[4], double x[4])
{
    double rows[4][5];
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            rows[row][column] = m[4 * column + row];
        rows[row][4] = b[row];
    }
    for (int step = 0; step < 4; ++step) {
        int pivot = step;
        for (int row = step + 1; row < 4; ++row)
            if (fabs(rows[row][step]) > fabs(rows[pivot][step])) pivot = row;
        double swap[5];
        memcpy(swap, rows[step], sizeof swap);
        memcpy(rows[step], rows[pivot], sizeof swap);
        memcpy(rows[pivot], swap, sizeof swap);
        for (int row = 0; row < 4; ++row) {
            double factor = row == step ? 0 : rows[row][step] / rows[step][step];
            for (int column = 0; column < 5; ++column)
                rows[row][column] -= factor * rows[step][column];
        }
    }
    for (int row = 0; row < 4; ++row)
        x[row] = rows[row][4] / rows[row][row];
}

static void unproject(const camera *c, double x, double y, double z, double out[3])
{
    double position[4];
    solve(c->projection, (double[4]){x, y, z, 1}, position);
    for (int i = 0; i < 3; ++i)
        out[i] = position[i] / position[3];
}

/* Where the ray through NDC (x, y) is at a view depth: on the line between two of its unprojected points. */
static void point_at_depth(const camera *c, double x, double y, double depth, double out[3])
{
    double a[3], b[3];
    unproject(c, x, y, 0.25, a);
    unproject(c, x, y, 0.75, b);
    double along = (-depth - a[2]) / (b[2] - a[2]);
    for (int i = 0; i < 3; ++i)
        out[i] = a[i] + along * (b[i] - a[i]);
}

static double window_depth(const camera *c, const double position[3])
{
    double clip[4];
    for (int row = 0; row < 4; ++row) {
        clip[row] = c->projection[12 + row];
        for (int column = 0; column < 3; ++column)
            clip[row] += c->projection[4 * column + row] * position[column];
    }
    double ndc = clip[2] / clip[3];
    return c->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? ndc : 0.5 + 0.5 * ndc;
}

/* ---- The tests ---- */

static struct ew_frame_block pack(const camera *c)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    memcpy(frame.projection, c->projection, sizeof frame.projection);
    frame.clip_depth = c->clip_depth;
    frame.interval_start = c->start;
    frame.interval_end = c->end;
    frame.viewport_x = X;
    frame.viewport_y = Y;
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    ew_sources sources = {.epsilon = 1};
    ew_error error = {EW_OK, ""};
    ew_plan plan;
    if (ew_plan_frame(&plan, &sources, NULL, &frame, &error) != EW_OK) fail_msg("%s is refused: %s", c->name, error.text);
    return plan.uniforms.frame;
}

/* Calls `check` with pixels' centres in window coordinates, all over the viewport of every camera. */
static void for_all_pixels(void (*check)(const camera *c, const struct ew_frame_block *block, const double pixel[2],
                                         const double ndc[2]))
{
    camera cameras[CAMERA_COUNT];
    make_cameras(cameras);
    for (int i = 0; i < CAMERA_COUNT; ++i) {
        struct ew_frame_block block = pack(&cameras[i]);
        for (int step = 0; step < 9; ++step) {
            double window[2] = {X + step % 3 * (WIDTH / 2 - 1) + 0.5, Y + step / 3 * (HEIGHT / 2 - 1) + 0.5};
            double pixel[2] = {window[0] - (double)block.pixel_center.x, window[1] - (double)block.pixel_center.y};
            double ndc[2] = {2 * (window[0] - X) / WIDTH - 1, 2 * (window[1] - Y) / HEIGHT - 1};
            check(&cameras[i], &block, pixel, ndc);
        }
    }
}

static double linear(const ew_vec4 *v, int component, const double pixel[2])
{
    const float *center = &v[0].x, *right = &v[1].x, *up = &v[2].x;
    return (double)center[component] + pixel[0] * (double)right[component] + pixel[1] * (double)up[component];
}

static void check_ray(const camera *c, const struct ew_frame_block *block, const double pixel[2], const double ndc[2])
{
    const ew_vec4 ray[3] = {block->ray_center, block->ray_right, block->ray_up};
    double start[3], end[3], length = c->end - c->start;
    point_at_depth(c, ndc[0], ndc[1], c->start, start);
    point_at_depth(c, ndc[0], ndc[1], c->end, end);
    for (int i = 0; i < 2; ++i) {
        check_close(linear(ray, i, pixel), start[i] / length, 5e-7 * (1 + fabs(start[i] / length)));
        check_close(linear(ray, 2 + i, pixel), (end[i] - start[i]) / length, 5e-7 * (1 + fabs((end[i] - start[i]) / length)));
    }
}

static void rays_go_through_the_centres_of_pixels(void **state)
{
    (void)state;
    for_all_pixels(check_ray);
}

/* Window depth comes as a float and its rounding error: far more than a float's digits, since opaque depth may be close. */
static double packed_depth(const ew_vec4 *depth, const double pixel[2])
{
    return (double)depth->x + ((double)depth->y + (double)depth->z * pixel[0] + (double)depth->w * pixel[1]);
}

static double slope_error(const ew_vec4 *depth)
{
    return 6e-8 * (fabs((double)depth->z) * WIDTH + fabs((double)depth->w) * HEIGHT);
}

static void check_window_depth(const camera *c, const struct ew_frame_block *block, const double pixel[2], const double ndc[2])
{
    double start[3], end[3];
    point_at_depth(c, ndc[0], ndc[1], c->start, start);
    point_at_depth(c, ndc[0], ndc[1], c->end, end);
    check_close(packed_depth(&block->depth_start, pixel), window_depth(c, start), 1e-13 + slope_error(&block->depth_start));
    check_close(packed_depth(&block->depth_end, pixel), window_depth(c, end), 1e-13 + slope_error(&block->depth_end));
}

static void window_depths_of_both_ends_have_more_digits_than_floats(void **state)
{
    (void)state;
    for_all_pixels(check_window_depth);
}

/* glsl/depth.glsl's formula, in double precision. */
static double opaque_parameter(const struct ew_frame_block *block, const double pixel[2], double depth)
{
    double behind_start = (double)block->depth_scale.x * (depth - packed_depth(&block->depth_start, pixel));
    double before_end = (double)block->depth_scale.y * (packed_depth(&block->depth_end, pixel) - depth);
    if (behind_start <= 0) return 0;
    if (before_end <= 0) return 1;
    return behind_start / (behind_start + before_end);
}

static void check_opaque_parameter(const camera *c, const struct ew_frame_block *block, const double pixel[2],
                                   const double ndc[2])
{
    double start[3], end[3];
    point_at_depth(c, ndc[0], ndc[1], c->start, start);
    point_at_depth(c, ndc[0], ndc[1], c->end, end);
    const double parameters[] = {-0.01, 0, 1e-4, 0.01, 0.3, 0.5, 0.9, 1, 1.01};
    for (size_t i = 0; i < sizeof parameters / sizeof parameters[0]; ++i) {
        double position[3], s = parameters[i];
        for (int j = 0; j < 3; ++j)
            position[j] = start[j] + s * (end[j] - start[j]);
        double depth = window_depth(c, position);
        bool is_beyond_near_or_far = depth < 0 || depth > 1;
        if ((s < 0 || s > 1) && is_beyond_near_or_far) continue;
        check_close(opaque_parameter(block, pixel, depth), s < 0 ? 0 : s > 1 ? 1 : s, 2e-7);
    }
}

static void opaque_depth_tells_where_the_ray_ends(void **state)
{
    (void)state;
    for_all_pixels(check_opaque_parameter);
}

static void expect_projection_refused(int element, double value)
{
    ew_sources sources = {.epsilon = 1e-3};
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    ew_plan plan;
    ew_error error = {EW_OK, ""};
    frame.viewport_width = frame.viewport_height = 64;
    assert_int_equal(ew_plan_frame(&plan, &sources, NULL, &frame, NULL), EW_OK);
    frame.projection[element] = value;
    ew_result result = ew_plan_frame(&plan, &sources, NULL, &frame, &error);
    check_refused(result, &error, EW_ERROR_INVALID_ARGUMENT, "projection");
}

/* Where they would overflow in the shader, and become pixels that are not numbers. */
static void rays_and_depths_beyond_a_floats_range_are_refused(void **state)
{
    (void)state;
    expect_projection_refused(0, 1e-39);
    expect_projection_refused(5, 1e-7);
    expect_projection_refused(8, 1e308);
    expect_projection_refused(9, -1e39);
    expect_projection_refused(4, 1e308);
    expect_projection_refused(14, -1e39);
    expect_projection_refused(10, 1e308);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_go_through_the_centres_of_pixels),
        cmocka_unit_test(window_depths_of_both_ends_have_more_digits_than_floats),
        cmocka_unit_test(opaque_depth_tells_where_the_ray_ends),
        cmocka_unit_test(rays_and_depths_beyond_a_floats_range_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
