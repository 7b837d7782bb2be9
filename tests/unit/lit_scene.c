/* Places that sources light: see lit_scene.h. */
#include "lit_scene.h"

#include <math.h>
#include <string.h>

ew_frame_desc lit_scene_plain_frame(void)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    const double projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.001, -1, 0, 0, -0.02, 0};
    memcpy(frame.projection, projection, sizeof projection);
    frame.viewport_width = frame.viewport_height = LIT_SCENE_SIZE;
    return frame;
}

void lit_scene_make_parallel(ew_frame_desc *frame, double half_size)
{
    double *p = frame->projection;
    p[0] /= half_size;
    p[4] /= half_size;
    p[5] /= half_size;
    p[10] = -0.01; /* near -100 and far 100 */
    p[11] = p[14] = 0;
    p[15] = 1;
}

/* Perspective or parallel; off-axis, sheared, or with an apex beside the eye; with or without an interval. The axes are the
 * world's of the view. */
static ew_frame_desc random_frame(uint64_t *random, double axes[3][3], const double eye[3])
{
    ew_frame_desc frame = lit_scene_plain_frame();
    double a = random_between(random, -3, 3), b = random_between(random, -3, 3);
    const double turned[3][3] = {
        {cos(a), 0, sin(a)}, {sin(a) * sin(b), cos(b), -cos(a) * sin(b)}, {-sin(a) * cos(b), sin(b), cos(a) * cos(b)}};
    memcpy(axes, turned, sizeof turned);
    for (int row = 0; row < 3; ++row) {
        frame.view[12 + row] = 0;
        for (int column = 0; column < 3; ++column) {
            frame.view[4 * column + row] = axes[row][column];
            frame.view[12 + row] -= axes[row][column] * eye[column];
        }
    }
    bool is_oblique = random_chance(random, 0.5);
    const int oblique[] = {1, 4, 8, 9, 12, 13};
    for (int i = 0; is_oblique && i < 6; ++i)
        frame.projection[oblique[i]] = random_between(random, -0.5, 0.5);
    if (random_chance(random, 0.3)) lit_scene_make_parallel(&frame, random_between(random, 1, 4));
    if (random_chance(random, 0.5)) {
        frame.interval_start = random_between(random, 0.1, 3);
        frame.interval_end = frame.interval_start + random_between(random, 0.5, 6);
    }
    return frame;
}

bool lit_scene_project(const ew_frame_desc *frame, const double world[3], double seen[3])
{
    double view[4] = {0, 0, 0, 1}, clip[4] = {0};
    bool is_parallel = frame->projection[11] == 0, has_interval = frame->interval_end > 0;
    for (int row = 0; row < 3; ++row) {
        view[row] = frame->view[12 + row];
        for (int column = 0; column < 3; ++column)
            view[row] += frame->view[4 * column + row] * world[column];
    }
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            clip[row] += frame->projection[4 * column + row] * view[column];
    seen[0] = clip[0] / clip[3];
    seen[1] = clip[1] / clip[3];
    seen[2] = -view[2];
    if (has_interval) return seen[2] >= frame->interval_start && seen[2] <= frame->interval_end;
    return seen[2] > (is_parallel ? -100 : 0);
}

void lit_scene_make(lit_scene *made, const source_kind *kind, uint64_t *random)
{
    *made = (lit_scene){.reach = random_between(random, 0.05, 1.5), .desc.epsilon = 1e-3};
    random_place place = {.random = random, .start = -3, .end = 6, .slope = {0.3, 0.3}, .size = {2, 2}};
    for (int i = 0; i < 3; ++i)
        place.eye[i] = random_between(random, -100, 100);
    made->frame = random_frame(random, place.axes, place.eye);
    kind->make(&place, &made->source, NULL, made->points);
    source_light light = {.coefficient = 1, .core = 0.04, .reach = made->reach};
    memcpy((char *)&made->source + kind->light_offset, &light, sizeof light);
    set_source_list(kind, &made->desc, &made->source);
    set_source_count(kind, &made->desc, 1);
    for (int i = 0; i < 3; ++i)
        made->view.middle[i] = place.eye[i] - place.axes[2][i];
}

void lit_scene_place(lit_scene *of, const source_kind *kind, uint64_t *random, double place[3])
{
    double away[3], length = 0;
    of->view.length = pow(10, random_between(random, 0, 3));
    kind->place(&of->source, &of->view, random_unit(random), place);
    do {
        length = 0;
        for (int i = 0; i < 3; ++i) {
            away[i] = random_between(random, -1, 1);
            length += away[i] * away[i];
        }
    } while (length > 1 || length < 1e-4);
    for (int i = 0; i < 3; ++i)
        place[i] += 0.999 * of->reach * away[i] / sqrt(length);
}
