// The structures of the uniform block, which C and GLSL share. All members are vec4 or ivec4, so std140 lays them out as C
// does. src/model/layout.h includes this file, and it comes first in every shader.
//
// Ray space: the shader's unit of length is the interval; of the world integral, how far away the sources are. Its origin (the
// anchor) is the point of the viewing axis at view depth interval_start, and its axes are the view's. A ray is
// L(s) = S + s V with S.z = 0 and V.z = -1. s runs from 0 to 1, in the world integral to the interval's length.

struct ew_frame_block {
    vec4 pixel_center; // xy: where NDC (0, 0) lies in gl_FragCoord; z, w: the target's steps (see ew_target_step)
    vec4 ray_center;   // xy: S.xy, zw: V.xy of the ray there
    vec4 ray_right;    // growth of both from one pixel to the next on the right
    vec4 ray_up;       // growth of both from one pixel to the next above
    vec4 depth_start;  // window depth of S: x + y at pixel_center (a float and its rounding error), zw: growth to the right, up.
                       // The eye has none: if S is there, a place close before it stands for S
    vec4 depth_end;    // window depth of E, in the same form
    vec4 depth_scale;  // x, y: clip w where depth_start and depth_end are, both negated for reversed-Z; z: the depth of no surface;
                       // w: s of depth_start
    vec4 decay;        // x: beta, y: epsilon, z: tolerance of a panel (see ew_tolerance), w: length of the interval
    vec4 ray_space_x;  // x in ray space of a position relative to the eye: dot(ray_space_x, vec4(position, 1))
    vec4 ray_space_y;  // its y
    vec4 ray_space_z;  // its z
    vec4 core_floor;   // x: squared growth of the least core radius with view depth, y: view depth of the anchor; z: its square
                       // where the view is parallel, both in units of ray space; w: how thick things are that cast shadows
    vec4 light;        // of sources on surfaces: x: the gain, in the unit of ray space, y: the reach; zw: half of the viewport's size
                       // in pixels
    ivec4 choices;     // x: number of Simpson's divisions; y: the host's normals, 1 of the view + 2 biased; z: 1 if the view is one
                       // in perspective
};

// What adaptive resolution knows of the frame.
struct ew_grid_block {
    ivec4 viewport; // what of the frame's the sources can light: xy: its first pixel, zw: its size in pixels
    vec4 tolerance; // x: how much an interpolated pixel may be off, relative to its light or to y times the picture's largest;
                    // z: the unit of the texture of sources at which the lists begin; w: how many entries a path takes in them
    ivec4 tiles;    // x: columns of tiles, y: log2 of a tile's width in pixels, zw: where the first one begins, from xy of `viewport`
};

// Fog, in units of ray space.
struct ew_fog_block {
    vec4 density; // x: the extinction, unless it changes with height; y: s where the fog of the frame's rays begins
    vec4 height;  // that is exp(-dot(height, vec4(p, 1))) at a place p, if it does
    ivec4 bodies; // x: how many bodies of media there are, y: how many of these are boxes, which come first
};

// A body of a medium. A place p of ray space is at dot(row, vec4(p, 1)) in the body's own space, where it is the cube from -1 to 1 or
// the unit ball.
struct ew_medium_block {
    vec4 row_x;
    vec4 row_y;
    vec4 row_z;
    vec4 light; // xyz: its light, albedo times ambient, w: its extinction
};

// Adaptive resolution divides the viewport into square cells of EW_CELL_SIZE pixels, and these stand in blocks of EW_BLOCK_CELLS by
// EW_BLOCK_CELLS. Nodes are at the cells' corners, and more in the middle of cells; EW_NODE_MARGIN more lie beyond the blocks on either side. EW_PEAK_SIZE: over
// how many nodes, in each direction, a pixel of the peak pass goes.
#define EW_CELL_SIZE 8
#define EW_BLOCK_CELLS 4
#define EW_NODE_MARGIN (2 * EW_BLOCK_CELLS)
#define EW_PEAK_SIZE 16

// Tiles, over which there are lists of the sources that may light them, are as wide as blocks or, where lists would be too long, wider by
// a power of two. The first tile begins where the first node is. A texture of sources is EW_TEXTURE_WIDTH wide.
#define EW_TILE_SIZE_LOG2 5
#define EW_TEXTURE_WIDTH 1024

// How many bodies of media there may be.
#define EW_MEDIUM_ROOM 16

// How many kinds of sources there are, and how many ivec4 their counts take.
#define EW_KIND_COUNT 5
#define EW_COUNT_VECTORS ((EW_KIND_COUNT + 3) / 4)

// How many lists of sources a tile may have: one for each kind, but three for paths, since beams, polylines and paths with bent pieces are
// integrated in different ways. And how many ivec4 the places of these lists in the table take, with the end of the last.
#define EW_LIST_COUNT 7
#define EW_LIST_VECTORS ((EW_LIST_COUNT + 4) / 4)

// The blocks of the sources. In every kind, `color` is the light's colour where B = 1, and its w the coefficient times alpha.
// `glow` is: x: the core's radius, y: the reach, 0 for none, z: the sharpness, w: the brightness. It comes last, and is left out of
// the uniform block where no source has a reach or a core of its own: then x is the frame's epsilon.

struct ew_point_block {
    vec4 position;
    vec4 color;
    vec4 glow;
};

struct ew_line_block {
    vec4 position; // the point of the line nearest to the anchor
    vec4 direction;
    vec4 color;
    vec4 glow;
};

struct ew_torus_block {
    vec4 center;
    vec4 axis; // w: radius
    vec4 color;
    vec4 glow;
};

// The arc C(tau) = origin + slope_x tau axis_x + (slope_y tau + bend tau^2) axis_y with tau in [first, last], last - first = 1.
// The origin is the parabola's vertex, where slope_y is 0, unless that is far off the arc; then it is the arc's middle.
struct ew_curve_block {
    vec4 origin; // w: the mean of the weights, 1 without
    vec4 axis_x; // w: slope_x >= 0
    vec4 axis_y; // w: slope_y
    vec4 axis_z; // w: bend >= 0
    vec4 domain; // x: first, y: last, z: the first weight piece, w: how many pieces there are (0: none)
    vec4 color;
    vec4 glow;
};

// A chain of pieces that shines as one. Its pieces stand behind all blocks and weights.
struct ew_path_block {
    vec4 ball;    // a ball around the path: its centre, w: its radius
    vec4 beam;    // of a straight beam, a path of one straight piece: xyz: from the ball's centre to its end
    vec4 pieces;  // x: the first vec4 of the first piece, y: number of pieces, z: 1 if they are ew_bent_block, else 0; w: 1 if closed
                  // y is 0 for a straight beam: it has no pieces but itself
    vec4 weights; // x: the first weight piece, y: how many there are (0: none), z: the mean of the weights
    vec4 color;
    vec4 glow;
};

// A straight piece of a path; w of each end is the path's parameter t there.
struct ew_straight_block {
    vec4 start;
    vec4 end;
};

// A bent piece of a path: see ew_curve_block.
struct ew_bent_block {
    vec4 origin;
    vec4 axis_x; // w: slope_x >= 0
    vec4 axis_y; // w: slope_y
    vec4 axis_z; // w: bend >= 0
    vec4 domain; // x: first, y: last, zw: t at both
    vec4 ball;   // a ball around the piece: its centre, w: its radius
    vec4 along;  // of a cylinder around the piece, whose axis goes through the ball's centre: its direction, w: its radius
};

// How many vec4 a piece takes.
#define EW_STRAIGHT_UNITS 2
#define EW_BENT_UNITS 7

// One polynomial piece of S(t), equation (15): x + y f + z f^2 with f in [0, 1] along the piece.
struct ew_weight_block {
    vec4 polynomial;
};
