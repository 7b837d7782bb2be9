/* A scene's camera as matrices: see camera.h. */
#include "camera.h"
#include "vector.h"

void camera_axes(const scene_camera *camera, double result[3][3])
{
    double backward[3], up[3], right[3];
    vector_subtract(camera->eye, camera->target, backward);
    vector_normalize(backward, result[2]);
    vector_normalize(camera->up, up);
    vector_cross(up, result[2], right);
    vector_normalize(right, result[0]);
    vector_cross(result[2], result[0], result[1]);
}

void camera_turn_to_view(const scene_camera *camera, const double direction[3], double result[3])
{
    double rotation[3][3];
    camera_axes(camera, rotation);
    for (int i = 0; i < 3; i++)
        result[i] = vector_dot(rotation[i], direction);
}

void camera_to_view(const scene_camera *camera, const double position[3], double result[3])
{
    double from_eye[3];
    vector_subtract(position, camera->eye, from_eye);
    camera_turn_to_view(camera, from_eye, result);
}

void camera_view(const scene_camera *camera, double view[16])
{
    double rotation[3][3];
    camera_axes(camera, rotation);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            view[4 * column + row] = rotation[row][column];
        view[12 + row] = -vector_dot(rotation[row], camera->eye);
        view[4 * row + 3] = 0;
    }
    view[15] = 1;
}

void camera_projection(const scene_camera *camera, double aspect, double projection[16])
{
    for (int i = 0; i < 16; i++)
        projection[i] = 0;
    double near_depth = camera->near_depth, far_depth = camera->far_depth, depth = far_depth - near_depth;
    if (camera->orthographic) {
        projection[5] = 2 / camera->height;
        projection[10] = -2 / depth;
        projection[14] = -(far_depth + near_depth) / depth;
        projection[15] = 1;
    } else {
        projection[5] = 1 / tan(camera->fov_y_degrees * M_PI / 360);
        projection[10] = -(far_depth + near_depth) / depth;
        projection[11] = -1;
        projection[14] = -2 * far_depth * near_depth / depth;
    }
    projection[0] = projection[5] / aspect;
}
