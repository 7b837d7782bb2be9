/* Sources as lines: see peer_outline.h. */
#include "peer_outline.h"
#include "path_parts.h"
#include "reference_weight.h"
#include "vector.h"

#include <math.h>

/* Of the places between which the length is measured. */
enum { LENGTH_PARTS = 256 };

/* How much of an endless line is drawn, in reaches to both sides of the place nearest to the middle of the view. */
#define LINE_REACHES 8

/* Only an endless line needs to know what the camera sees: the middle of the view, as far away as the line's position is. */
static void place_in_world(const outline *shape, double u, double result[3])
{
    const double *m = shape->view;
    source_view view = {.length = LINE_REACHES * shape->light.reach};
    double eye[3];
    for (int i = 0; i < 3; i++)
        eye[i] = -(m[4 * i] * m[12] + m[4 * i + 1] * m[13] + m[4 * i + 2] * m[14]);
    double distance = 0;
    for (int i = 0; i < 3; i++)
        distance -= m[4 * i + 2] * (source_position(shape->kind, shape->source)[i] - eye[i]);
    for (int i = 0; i < 3; i++)
        view.middle[i] = eye[i] - distance * m[4 * i + 2];
    shape->kind->place(shape->source, &view, u, result);
}

static double weight_at(const outline *shape, double u)
{
    if (shape->kind == source_kinds[KIND_PATH]) {
        const ew_path *path = shape->source;
        return reference_weight(path->weights, path->weight_count, u);
    }
    if (shape->kind == source_kinds[KIND_CURVE]) {
        const ew_curve *curve = shape->source;
        return reference_weight(curve->weights, curve->weight_count, u);
    }
    return 1;
}

outline_place outline_at(const outline *shape, double u)
{
    const double step = 1e-4;
    double span = 1 / (double)shape->spans, first = floor(fmin(u / span + 1e-9, (double)shape->spans - 0.5)) * span;
    /* Both within the span, so that corners stay corners. */
    double before = fmax(u - step * span, first), after = fmin(u + step * span, first + span);
    double here[3], back[3], ahead[3], tangent[3];
    outline_place place = {.weight = weight_at(shape, u)};
    place_in_world(shape, u, here);
    place_in_world(shape, before, back);
    place_in_world(shape, after, ahead);
    vector_subtract(ahead, back, tangent);
    place.speed = shape->is_point ? 0 : vector_length(tangent) / (after - before);
    vector_normalize(tangent, tangent);
    for (int row = 0; row < 3; row++) {
        const double *m = shape->view;
        place.position[row] = (float)(m[row] * here[0] + m[4 + row] * here[1] + m[8 + row] * here[2] + m[12 + row]);
        place.tangent[row] = (float)(m[row] * tangent[0] + m[4 + row] * tangent[1] + m[8 + row] * tangent[2]);
    }
    if (place.speed == 0) place.tangent[0] = 1;
    return place;
}

outline outline_of(const source_kind *kind, const void *source, double epsilon, const double view[16])
{
    outline shape = {.kind = kind,
                     .source = source,
                     .view = view,
                     .light = source_light_of(kind, source),
                     .spans = 1,
                     .is_point = kind == source_kinds[KIND_POINT],
                     .is_closed = kind == source_kinds[KIND_TORUS]};
    source_light *light = &shape.light;
    if (light->core == 0) light->core = epsilon;
    if (light->brightness == 0 && light->reach > 0)
        light->brightness = light->coefficient * 2 * log(light->reach / light->core);
    if (kind == source_kinds[KIND_PATH]) {
        const ew_path *path = source;
        shape.spans = path_span_count(path);
        shape.is_closed = path->is_closed;
    }
    for (int i = 0; i < LENGTH_PARTS && !shape.is_point; i++)
        shape.length += outline_at(&shape, (i + 0.5) / LENGTH_PARTS).speed / LENGTH_PARTS;
    return shape;
}

size_t outline_parts(const outline *shape, int count)
{
    return shape->is_point ? 1 : ((size_t)count + shape->spans - 1) / shape->spans;
}
