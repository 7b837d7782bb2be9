/* The selected part over the picture: see edit_outline.h. */
#include "edit_outline.h"
#include "camera_ray.h"
#include "part_handle.h"
#include "part_shape.h"

static const unsigned char pale[4] = {255, 255, 255, 110}, white[4] = {255, 255, 255, 255}, black[4] = {0, 0, 0, 255};

/* What the pieces of a shape are drawn with. */
typedef struct shape_drawing {
    demo_overlay *overlay;
    const edit_outline *outline;
} shape_drawing;

/* Returns false where the position is not in front of the camera. */
static bool pixel_of(const edit_outline *outline, const double position[3], double pixel[2])
{
    double place[2], depth = camera_project(outline->camera, outline->width / outline->height, position, place);
    pixel[0] = (1 + place[0]) * outline->width / 2;
    pixel[1] = (1 - place[1]) * outline->height / 2;
    return depth > outline->camera->near_depth;
}

static void draw_piece(void *user, const double a[3], const double b[3])
{
    const shape_drawing *drawing = user;
    double from[2], to[2];
    if (pixel_of(drawing->outline, a, from) && pixel_of(drawing->outline, b, to))
        overlay_line(drawing->overlay, from, to, 1.5 * drawing->outline->scale, pale);
}

static bool has_stem(const part_handle *handle)
{
    return handle->kind == HANDLE_DIRECTION || handle->kind == HANDLE_RADIUS;
}

static void draw_handle(shape_drawing *drawing, const part_handle *handle)
{
    double pixel[2], half = 4 * drawing->outline->scale, edge = half + drawing->outline->scale;
    if (has_stem(handle)) draw_piece(drawing, handle->from, handle->position);
    if (!pixel_of(drawing->outline, handle->position, pixel)) return;
    overlay_box(drawing->overlay, pixel[0] - edge, pixel[1] - edge, 2 * edge, 2 * edge, black);
    overlay_box(drawing->overlay, pixel[0] - half, pixel[1] - half, 2 * half, 2 * half, white);
}

void edit_outline_draw(demo_overlay *overlay, const edit_outline *outline, scene_part part)
{
    shape_drawing drawing = {overlay, outline};
    part_shape(outline->scene, part, draw_piece, &drawing);
    size_t count = part_handle_count(outline->scene, outline->text, part);
    for (size_t i = 0; i < count; i++) {
        part_handle handle = part_handle_at(outline->scene, outline->text, part, outline->camera, i);
        draw_handle(&drawing, &handle);
    }
}
