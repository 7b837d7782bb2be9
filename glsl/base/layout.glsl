// What C and GLSL share: the uniform block's structures (std140; all members are vec4 or ivec4, so the C structures have the
// same layout) and how many vec4 each source takes. Included by src/layout.h and put first into every shader.
//
// Ray space: the shader's unit of length is the interval, its origin (the anchor) the point of the viewing axis at view depth
// interval_start, its axes are the view's. A ray is L(s) = S + s V with S.z = 0 and V.z = -1, and s runs from 0 to 1.

struct ew_frame_block {
    vec4 pixel_center;  // xy: where NDC (0, 0) lies in gl_FragCoord; zw: unused
    vec4 ray_center;    // xy: S.xy, zw: V.xy of the ray there
    vec4 ray_right;     // by how much both grow a pixel to the right
    vec4 ray_up;        // by how much both grow a pixel upwards
    vec4 depth_start;   // window depth of S: x + y at pixel_center (a float and its rounding error), zw: growth a pixel right, up
    vec4 depth_end;     // likewise of E
    vec4 depth_scale;   // x, y: clip w of S and of E, negated both for reversed-Z; zw: unused
    vec4 decay;         // x: beta, y: epsilon, z: how rough a panel of the adaptive integrator may be, relative to the integral
    vec4 ray_space_x;   // ray space from the world's axes relative to the eye: x = dot(ray_space_x, vec4(position, 1)), ...
    vec4 ray_space_y;
    vec4 ray_space_z;
    ivec4 source_count; // points, lines, tori, curves
    ivec4 simpson;      // x: number of divisions
};

struct ew_point_block {
    vec4 position; // w: coefficient times alpha, as in all kinds
    vec4 color;
};

struct ew_line_block {
    vec4 position; // the point of the line nearest to the anchor
    vec4 direction;
    vec4 color;
};

struct ew_torus_block {
    vec4 center;
    vec4 axis; // w: radius
    vec4 color;
};

// The arc C(tau) = origin + slope_x tau axis_x + (slope_y tau + bend tau^2) axis_y with tau in [first, last], last - first = 1.
// The origin is the parabola's vertex, where slope_y is 0, unless that is far off the arc; then it is the arc's middle.
struct ew_curve_block {
    vec4 origin;
    vec4 axis_x; // w: slope_x >= 0
    vec4 axis_y; // w: slope_y
    vec4 axis_z; // w: bend >= 0
    vec4 color;  // w: the mean of the weights, 1 without
    vec4 domain; // x: first, y: last, z: the first weight piece, w: how many pieces there are (0: none)
};

// One polynomial piece of S(t), equation (15): x + y f + z f^2 with f in [0, 1] along the piece.
struct ew_weight_block {
    vec4 polynomial;
};

#define EW_POINT_SIZE 2
#define EW_LINE_SIZE 3
#define EW_TORUS_SIZE 3
#define EW_CURVE_SIZE 6
#define EW_WEIGHT_SIZE 1
