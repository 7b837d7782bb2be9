/* What EW_OUTPUT_SURFACES promises: the host's picture, lit by what its surfaces receive, from nothing but its depth.
 *
 *     surfaces_test CONTEXT    one of the names in context.h */
#include "program_context.h"
#include "reference_irradiance.h"
#include "stage.h"
#include "vector.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double distance = 6, near_depth = 0.06, far_depth = 600; /* of stage_frame(6) */
static const GLfloat albedo[4] = {0.5f, 0.25f, 0.125f, 0.7f};

/* ---- The host's scene --------------------------------------------------------------------------------------------------- */

/* A surface that a ray meets at origin + t direction. */
typedef struct hit {
    double t; /* HUGE_VAL: none */
    int face; /* different on the two sides of an edge */
    double normal[3];
} hit;

static const double ball_center[3] = {0.9, -0.3, 0.2}, ball_radius = 0.7;
static const double slab[2][3] = {{-1.1, -1, -0.5}, {-0.9, 0.3, 0.5}};

enum { BALL = 1, FLOOR, WALL, SLAB };

static void take(hit *best, double t, int face, const double normal[3])
{
    if (!(t > 1e-9 && t < best->t)) return;
    best->t = t;
    best->face = face;
    memcpy(best->normal, normal, sizeof best->normal);
}

static void meet_ball(const double origin[3], const double direction[3], hit *best)
{
    double to[3], b = 0, c = -ball_radius * ball_radius, a = vector_dot(direction, direction), normal[3];
    for (int i = 0; i < 3; i++)
        to[i] = origin[i] - ball_center[i];
    b = vector_dot(to, direction);
    c += vector_dot(to, to);
    if (b * b < a * c) return;
    double t = (-b - sqrt(b * b - a * c)) / a;
    for (int i = 0; i < 3; i++)
        normal[i] = (to[i] + t * direction[i]) / ball_radius;
    take(best, t, BALL, normal);
}

static void meet_slab(const double origin[3], const double direction[3], hit *best)
{
    double first = -HUGE_VAL, last = HUGE_VAL, normal[3] = {0};
    int face = 0;
    for (int i = 0; i < 3; i++) {
        double low = (slab[0][i] - origin[i]) / direction[i], high = (slab[1][i] - origin[i]) / direction[i];
        last = fmin(last, fmax(low, high));
        if (fmin(low, high) <= first) continue;
        first = fmin(low, high);
        memset(normal, 0, sizeof normal);
        normal[i] = direction[i] > 0 ? -1 : 1;
        face = SLAB + i;
    }
    if (first < last) take(best, first, face, normal);
}

static hit meet(const double origin[3], const double direction[3], bool has_things)
{
    hit best = {.t = HUGE_VAL};
    take(&best, (-1 - origin[1]) / direction[1], FLOOR, (const double[3]){0, 1, 0});
    take(&best, (-2 - origin[2]) / direction[2], WALL, (const double[3]){0, 0, 1});
    if (has_things) meet_ball(origin, direction, &best);
    if (has_things) meet_slab(origin, direction, &best);
    return best;
}

enum { PIXELS = STAGE_WIDTH * STAGE_HEIGHT };
static reference_surface surfaces[PIXELS];
static int faces[PIXELS];
static GLfloat depths[PIXELS], view_depths[PIXELS];

/* What the camera of stage_frame sees, or a parallel one of the same size at the origin. */
static void see(bool is_parallel, bool has_things)
{
    for (int i = 0; i < PIXELS; i++) {
        double x = (2 * (i % STAGE_WIDTH) + 1 - STAGE_WIDTH) * stage_slope() / STAGE_HEIGHT;
        double y = (2 * (i / STAGE_WIDTH) + 1 - STAGE_HEIGHT) * stage_slope() / STAGE_HEIGHT;
        const double eye[3] = {0, 0, distance}, beside[3] = {distance * x, distance * y, distance};
        const double spread[3] = {x, y, -1}, ahead[3] = {1e-12, 1e-12, -1}, *origin = is_parallel ? beside : eye;
        const double *direction = is_parallel ? ahead : spread;
        hit met = meet(origin, direction, has_things);
        faces[i] = met.face;
        for (int k = 0; k < 3; k++)
            surfaces[i].position[k] = origin[k] + met.t * direction[k];
        memcpy(surfaces[i].normal, met.normal, sizeof met.normal);
        view_depths[i] = (GLfloat)met.t;
        depths[i] = (GLfloat)(is_parallel ? (met.t - near_depth) / (far_depth - near_depth)
                                          : far_depth * (met.t - near_depth) / (met.t * (far_depth - near_depth)));
    }
}

/* Whether the surface goes on for two pixels on some side, to the left or right, and above or below. */
static bool has_normal(int pixel)
{
    const int steps[2] = {1, STAGE_WIDTH}, at[2] = {pixel % STAGE_WIDTH, pixel / STAGE_WIDTH};
    const int size[2] = {STAGE_WIDTH, STAGE_HEIGHT};
    for (int axis = 0; axis < 2; axis++) {
        bool goes_on = false;
        for (int side = -1; side <= 1; side += 2) {
            int end = at[axis] + 2 * side, step = side * steps[axis];
            if (end < 0 || end >= size[axis]) continue;
            goes_on = goes_on || (faces[pixel + step] == faces[pixel] && faces[pixel + 2 * step] == faces[pixel]);
        }
        if (!goes_on) return false;
    }
    return true;
}

static GLuint make_texture(GLint internal_format, GLenum format, GLenum type, const void *data)
{
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, STAGE_WIDTH, STAGE_HEIGHT, 0, format, type, data);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

/* ---- Its light ---------------------------------------------------------------------------------------------------------- */

#define LIGHT .brightness = 1, .color = {1, 0.5, 0.25}, .core = 0.05, .reach = 0.8

static const ew_point orb = {.position = {-0.2, 0.3, 0.4}, LIGHT};
static const double arc_corners[][3] = {{-1.6, 0.8, -1}, {0, 0.2, 0.6}, {1.7, 0.9, -1.2}};
static const ew_path beam = {.kind = EW_PATH_POLYLINE, .points = arc_corners, .point_count = 2, LIGHT};
static const ew_path arc = {.kind = EW_PATH_BSPLINE, .points = arc_corners, .point_count = 3, LIGHT};
static const ew_torus ring = {.center = {0.3, -0.2, 0.5}, .axis = {0.2, 1, 0.1}, .radius = 1.1, LIGHT};
static const ew_line line = {.position = {0, 0.5, 0}, .direction = {1, 0.1, -0.3}, LIGHT};

static const struct {
    const char *name;
    ew_sources_desc sources;
} scenes[] = {
    {"orb", {.points = &orb, .point_count = 1}},
    {"beam", {.paths = &beam, .path_count = 1}},
    {"arc", {.paths = &arc, .path_count = 1}},
    {"ring", {.tori = &ring, .torus_count = 1}},
    {"line", {.lines = &line, .line_count = 1}},
    {"all", {.points = &orb, .point_count = 1, .paths = &arc, .path_count = 1, .tori = &ring, .torus_count = 1}},
};
enum { SCENE_COUNT = sizeof scenes / sizeof *scenes };

static ew_frame_desc lit_frame(bool is_parallel)
{
    ew_frame_desc frame = stage_frame(distance);
    if (is_parallel) {
        const double half = distance * stage_slope();
        memset(frame.projection, 0, sizeof frame.projection);
        frame.projection[0] = STAGE_HEIGHT / (half * STAGE_WIDTH);
        frame.projection[5] = 1 / half;
        frame.projection[10] = -2 / (far_depth - near_depth);
        frame.projection[14] = -(far_depth + near_depth) / (far_depth - near_depth);
        frame.projection[15] = 1;
    }
    frame.output = EW_OUTPUT_SURFACES;
    frame.light_reach = 4;
    frame.light_gain = 60;
    return frame;
}

/* What the red, green and blue of a pixel were multiplied by, less 1. */
static void read_light(stage_picture drawn, int pixel, double light[3])
{
    const GLfloat *color = drawn[pixel / STAGE_WIDTH][pixel % STAGE_WIDTH];
    for (int i = 0; i < 3; i++)
        light[i] = (double)(color[i] / albedo[i]) - 1;
    assert_true(color[3] == albedo[3]);
}

/* How far off the light is, relative to the brightest surface. */
typedef struct light_error {
    double flat;  /* at the worst, where surfaces are flat */
    double round; /* likewise on the ball */
    int limb;     /* how many pixels of the ball are off by more than 2e-2 */
    int compared, of_ball;
} light_error;

static light_error error_of(const ew_frame_desc *frame, const ew_sources_desc *sources, stage_picture drawn)
{
    static double off[PIXELS];
    double brightest = 0;
    light_error error = {0};
    for (int i = 0; i < PIXELS; i++) {
        double truth[3], light[3];
        reference_irradiance(sources, frame->light_reach, &surfaces[i], NULL, truth);
        read_light(drawn, i, light);
        off[i] = 0;
        for (int k = 0; k < 3; k++) {
            brightest = fmax(brightest, frame->light_gain * truth[k]);
            off[i] = fmax(off[i], fabs(light[k] - frame->light_gain * truth[k]));
        }
    }
    assert_true(brightest > 0.1);
    for (int i = 0; i < PIXELS; i++) {
        if (!has_normal(i)) continue;
        double relative = off[i] / brightest, *worst = faces[i] == BALL ? &error.round : &error.flat;
        *worst = fmax(*worst, relative);
        error.compared++;
        error.of_ball += faces[i] == BALL;
        error.limb += faces[i] == BALL && relative > 2e-2;
    }
    return error;
}

/* A ball of 18 pixels bends too much for its depth to tell its normals at the limb. */
static void surfaces_are_lit_by_what_they_receive(void **state)
{
    (void)state;
    static stage_picture drawn;
    for (int is_parallel = 0; is_parallel < 2; is_parallel++) {
        ew_frame_desc frame = lit_frame(is_parallel);
        see(is_parallel, true);
        frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
        for (int scene = 0; scene < SCENE_COUNT; scene++) {
            stage_set(&scenes[scene].sources);
            stage_draw(&frame, albedo, drawn);
            const light_error error = error_of(&frame, &scenes[scene].sources, drawn);
            fprintf(stderr, "%s%s: flat %.2g, round %.2g, %d of %d pixels of the ball beyond 2e-2\n", scenes[scene].name,
                    is_parallel ? ", parallel" : "", error.flat, error.round, error.limb, error.of_ball);
            assert_true(error.compared > 9 * PIXELS / 10);
            assert_true(error.flat <= 1e-2);
            assert_true(error.round <= 0.25 && error.limb <= error.of_ball / 10);
        }
        gl.DeleteTextures(1, &frame.depth_texture);
    }
}

/* ---- What else the host may hand over ----------------------------------------------------------------------------------- */

/* The largest difference of two pictures of light, in what the albedo is multiplied by. */
static double difference(stage_picture one, stage_picture other)
{
    double largest = 0;
    for (int i = 0; i < PIXELS; i++) {
        double a[3], b[3];
        read_light(one, i, a);
        read_light(other, i, b);
        for (int k = 0; k < 3; k++)
            largest = fmax(largest, fabs(a[k] - b[k]));
    }
    return largest;
}

static void turn(double angle, const double v[3], double turned[3])
{
    turned[0] = cos(angle) * v[0] + sin(angle) * v[2];
    turned[1] = v[1];
    turned[2] = cos(angle) * v[2] - sin(angle) * v[0];
}

/* The camera is turned about y, and the world with it, so that normals in the world differ from those in the view. */
static void normals_of_the_host_are_taken_in_each_encoding(void **state)
{
    (void)state;
    const double angle = 0.8;
    static stage_picture drawn;
    static GLfloat normals[PIXELS][3];
    ew_point turned_orb = orb;
    ew_frame_desc frame = lit_frame(false);
    see(false, true);
    turn(angle, orb.position, turned_orb.position);
    stage_set(&(ew_sources_desc){.points = &turned_orb, .point_count = 1});
    for (int column = 0; column < 3; column++) { /* the inverse turn comes first */
        double axis[3] = {0}, back[3];
        axis[column] = 1;
        turn(-angle, axis, back);
        memcpy(&frame.view[4 * column], back, sizeof back);
    }
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    for (int encoding = EW_NORMAL_WORLD; encoding <= EW_NORMAL_VIEW_BIASED; encoding++) {
        bool is_view = encoding == EW_NORMAL_VIEW || encoding == EW_NORMAL_VIEW_BIASED;
        bool is_biased = encoding == EW_NORMAL_WORLD_BIASED || encoding == EW_NORMAL_VIEW_BIASED;
        for (int i = 0; i < PIXELS; i++) {
            double turned[3];
            turn(angle, surfaces[i].normal, turned);
            for (int k = 0; k < 3; k++)
                normals[i][k] = (GLfloat)(is_view ? surfaces[i].normal[k] : turned[k]);
            for (int k = 0; k < 3 && is_biased; k++)
                normals[i][k] = 0.5f * normals[i][k] + 0.5f;
        }
        frame.normal_texture = make_texture(GL_RGB32F, GL_RGB, GL_FLOAT, normals);
        frame.normal_encoding = (ew_normal_encoding)encoding;
        stage_draw(&frame, albedo, drawn);
        double worst = 0;
        for (int i = 0; i < PIXELS; i++) {
            double truth[3], light[3];
            reference_irradiance(&scenes[0].sources, frame.light_reach, &surfaces[i], NULL, truth);
            read_light(drawn, i, light);
            worst = fmax(worst, fabs(light[0] - frame.light_gain * truth[0]));
        }
        fprintf(stderr, "encoding %d: off by %.2g\n", encoding, worst);
        assert_true(worst < 2e-3);
        gl.DeleteTextures(1, &frame.normal_texture);
    }
    gl.DeleteTextures(1, &frame.depth_texture);
}

static void a_normal_that_is_none_is_dark(void **state)
{
    (void)state;
    static stage_picture drawn;
    static GLfloat normals[PIXELS][3];
    const GLfloat none[] = {0, (GLfloat)NAN, (GLfloat)INFINITY};
    ew_frame_desc frame = lit_frame(false);
    see(false, true);
    stage_set(&scenes[0].sources);
    for (int i = 0; i < PIXELS; i++)
        for (int k = 0; k < 3; k++)
            normals[i][k] = none[i % 3];
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    frame.normal_texture = make_texture(GL_RGB32F, GL_RGB, GL_FLOAT, normals);
    stage_draw(&frame, albedo, drawn);
    for (int i = 0; i < PIXELS; i++)
        assert_memory_equal(drawn[i / STAGE_WIDTH][i % STAGE_WIDTH], albedo, sizeof albedo);
    gl.DeleteTextures(1, &frame.depth_texture);
    gl.DeleteTextures(1, &frame.normal_texture);
}

/* However far light reaches, where there is no surface nothing is lit, and a depth that is no number is no surface. */
static void where_there_is_no_surface_nothing_is_lit(void **state)
{
    (void)state;
    static stage_picture drawn;
    static GLfloat nothing[PIXELS];
    ew_frame_desc frame = lit_frame(false);
    frame.light_reach = 1e6;
    frame.shadow_thickness = 1;
    stage_set(&scenes[SCENE_COUNT - 1].sources);
    for (int is_linear = 0; is_linear < 2; is_linear++) {
        const GLfloat far[2] = {1, (GLfloat)INFINITY};
        for (int i = 0; i < PIXELS; i++)
            nothing[i] = is_linear && i % 2 ? (GLfloat)NAN : far[is_linear];
        frame.depth_source = is_linear ? EW_DEPTH_TEXTURE_LINEAR : EW_DEPTH_TEXTURE;
        frame.depth_texture = is_linear ? make_texture(GL_R32F, GL_RED, GL_FLOAT, nothing)
                                        : make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, nothing);
        stage_draw(&frame, albedo, drawn);
        for (int i = 0; i < PIXELS; i++)
            assert_memory_equal(drawn[i / STAGE_WIDTH][i % STAGE_WIDTH], albedo, sizeof albedo);
        gl.DeleteTextures(1, &frame.depth_texture);
    }
}

static void view_depth_and_a_copied_depth_light_the_same(void **state)
{
    (void)state;
    static stage_picture expected, drawn;
    ew_frame_desc frame = lit_frame(false);
    see(false, true);
    stage_set(&scenes[SCENE_COUNT - 1].sources);
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    stage_draw(&frame, albedo, expected);
    const GLuint window_depth = frame.depth_texture;

    frame.depth_source = EW_DEPTH_TEXTURE_LINEAR;
    frame.depth_texture = make_texture(GL_R32F, GL_RED, GL_FLOAT, view_depths);
    stage_draw(&frame, albedo, drawn);
    double of_view_depth = difference(drawn, expected);
    gl.DeleteTextures(1, &frame.depth_texture);

    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, window_depth, 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    stage_draw(&frame, albedo, drawn);
    double of_copy = difference(drawn, expected);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteTextures(1, &window_depth);
    fprintf(stderr, "view depth: %.2g, a copy: %.2g\n", of_view_depth, of_copy);
    assert_true(of_view_depth < 2e-2);
    assert_true(of_copy == 0);
}

/* A plane that faces the camera, so that all samples of a pixel have one depth. */
static void every_sample_is_lit(void **state)
{
    (void)state;
    const GLfloat depth = (GLfloat)(far_depth * (6.5 - near_depth) / (6.5 * (far_depth - near_depth)));
    static stage_picture expected, drawn;
    ew_frame_desc frame = lit_frame(false);
    stage_set(&scenes[0].sources);
    for (int i = 0; i < PIXELS; i++)
        depths[i] = depth;
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    stage_draw(&frame, albedo, expected);
    gl.DeleteTextures(1, &frame.depth_texture);

    const GLenum format = gl.es ? GL_RGBA8 : GL_RGBA32F;
    canvas sampled = canvas_create(STAGE_WIDTH, STAGE_HEIGHT, format, GL_DEPTH_COMPONENT32F, 4);
    canvas resolved = canvas_create(STAGE_WIDTH, STAGE_HEIGHT, format, 0, 0);
    canvas_clear(&sampled, albedo);
    canvas_clear_depth(&sampled, depth, (const GLint[4]){0, 0, 1, 1}, depth);
    frame.framebuffer = sampled.framebuffer;
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    ew_error error = {.text = ""};
    if (ew_draw(stage_effect(), &frame, &error) != EW_OK) fail_msg("%s", error.text);
    canvas_resolve(&sampled, &resolved);
    canvas_read(&resolved, &drawn[0][0][0]);
    double largest = 0;
    for (int i = 0; i < PIXELS; i++) {
        const double is = (double)drawn[i / STAGE_WIDTH][i % STAGE_WIDTH][0];
        const double should = (double)expected[i / STAGE_WIDTH][i % STAGE_WIDTH][0];
        largest = fmax(largest, fabs(is - should));
    }
    assert_true(largest < (gl.es ? 2.0 / 255 : 1e-6));
    canvas_destroy(&sampled);
    canvas_destroy(&resolved);
}

/* ---- Shadows ------------------------------------------------------------------------------------------------------------ */

static bool is_shaded(const reference_surface *surface, const double light[3])
{
    double way[3], start[3];
    for (int i = 0; i < 3; i++) {
        start[i] = surface->position[i] + 1e-6 * surface->normal[i];
        way[i] = light[i] - start[i];
    }
    return meet(start, way, true).t < 1;
}

/* Of a point, whose shadows are sharp. What the camera cannot see may be wrong: behind the ball and the slab. */
static void things_cast_shadows(void **state)
{
    (void)state;
    static stage_picture bright, drawn;
    ew_frame_desc frame = lit_frame(false);
    see(false, true);
    stage_set(&scenes[0].sources);
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    stage_draw(&frame, albedo, bright);
    frame.shadow_thickness = 1;
    stage_draw(&frame, albedo, drawn);
    gl.DeleteTextures(1, &frame.depth_texture);
    int shaded = 0, lit = 0, missing = 0, wrong = 0;
    for (int i = 0; i < PIXELS; i++) {
        double without[3], with[3];
        read_light(bright, i, without);
        read_light(drawn, i, with);
        assert_true(with[0] <= without[0] + 1e-5);
        if (without[0] < 0.02) continue;
        bool is_dark = with[0] < 0.5 * without[0];
        if (is_shaded(&surfaces[i], orb.position))
            shaded++, missing += !is_dark;
        else
            lit++, wrong += is_dark;
    }
    fprintf(stderr, "shadows: %d of %d missing, %d of %d lit pixels dark\n", missing, shaded, wrong, lit);
    assert_true(shaded > 50 && lit > 500);
    assert_true(missing <= shaded / 10);
    assert_true(wrong <= lit / 50);
}

static void surfaces_cast_no_shadows_on_themselves(void **state)
{
    (void)state;
    static stage_picture bright, drawn;
    ew_frame_desc frame = lit_frame(false);
    see(false, false);
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    for (int scene = 0; scene < SCENE_COUNT; scene++) {
        stage_set(&scenes[scene].sources);
        frame.shadow_thickness = 0;
        stage_draw(&frame, albedo, bright);
        frame.shadow_thickness = 1;
        stage_draw(&frame, albedo, drawn);
        int darker = 0;
        for (int i = 0; i < PIXELS; i++) {
            double without[3], with[3];
            read_light(bright, i, without);
            read_light(drawn, i, with);
            darker += with[0] < without[0] - 1e-3;
        }
        fprintf(stderr, "%s: %d pixels darker\n", scenes[scene].name, darker);
        assert_int_equal(darker, 0);
    }
    gl.DeleteTextures(1, &frame.depth_texture);
}

/* ---- Refusals ----------------------------------------------------------------------------------------------------------- */

static void expect_refused(const ew_frame_desc *frame, const char *member)
{
    ew_error error = {.text = ""};
    assert_int_equal(ew_draw(stage_effect(), frame, &error), EW_ERROR_INVALID_ARGUMENT);
    if (!strstr(error.text, member)) fail_msg("\"%s\" does not name %s", error.text, member);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static void what_is_no_texture_of_normals_is_refused(void **state)
{
    (void)state;
    static const GLubyte nothing[PIXELS][3];
    ew_frame_desc frame = lit_frame(false);
    see(false, true);
    stage_set(&scenes[0].sources);
    expect_refused(&frame, "depth_texture");
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    frame.light_reach = 0;
    expect_refused(&frame, "light_reach");
    frame.light_reach = 4;
    frame.normal_texture = 12345;
    expect_refused(&frame, "normal_texture");
    GLuint cube;
    gl.GenTextures(1, &cube);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    frame.normal_texture = cube;
    expect_refused(&frame, "normal_texture");
    gl.DeleteTextures(1, &cube);
    if (api_has(33, 31, NULL)) { /* OpenGL ES 3.0 cannot be asked */
        frame.normal_texture = make_texture(GL_R32F, GL_RED, GL_FLOAT, depths);
        expect_refused(&frame, "normal_texture");
        gl.DeleteTextures(1, &frame.normal_texture);
        frame.normal_texture = make_texture(GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, nothing);
        gl.BindTexture(GL_TEXTURE_2D, frame.normal_texture);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        expect_refused(&frame, "normal_texture");
        gl.DeleteTextures(1, &frame.normal_texture);
    }
    gl.DeleteTextures(1, &frame.depth_texture);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: surfaces_test CONTEXT\n");
        return 2;
    }
    if (!stage_open(argv[1])) return 77;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_are_lit_by_what_they_receive),
        cmocka_unit_test(normals_of_the_host_are_taken_in_each_encoding),
        cmocka_unit_test(a_normal_that_is_none_is_dark),
        cmocka_unit_test(where_there_is_no_surface_nothing_is_lit),
        cmocka_unit_test(view_depth_and_a_copied_depth_light_the_same),
        cmocka_unit_test(things_cast_shadows),
        cmocka_unit_test(surfaces_cast_no_shadows_on_themselves),
        cmocka_unit_test(every_sample_is_lit),
        cmocka_unit_test(gl_has_nothing_to_say),
        cmocka_unit_test(what_is_no_texture_of_normals_is_refused), /* GL has: of the wrong target */
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    stage_close();
    return failed;
}
