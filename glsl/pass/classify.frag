// The classes of patches: how their pixels get their light. Cells come first (ew_stride is 1), then blocks.

// The largest light of the nodes.
uniform sampler2D ew_peak_texture;
// The field where the nodes' rays end.
uniform sampler2D ew_field_texture;
// The cells' classes, for blocks.
uniform sampler2D ew_cell_texture;
uniform int ew_stride;

out vec4 ew_class;

// How far the polynomial may be off the light. It goes through the node in the middle of the patch; how far it would be off there without
// that, its surplus, tells of all that is not smooth: a kink, as at a reach or where the nearest point jumps, or a core that passes between
// the nodes at the corners. Along the edges, Hermite's error where the light is smooth is 1 / 384 of the nodes' fourth differences.
const float EW_ERROR_OF_SURPLUS = 6.0;
const float EW_ERROR_OF_DIFFERENCE = 1.0 / 12.0;

vec4 ew_fourth_difference(const vec4 a, const vec4 b, const vec4 c, const vec4 d, const vec4 e)
{
    return abs(a - 4.0 * b + 6.0 * c - 4.0 * d + e);
}

// Adds an edge to the largest difference, and to the middle of Coons' patch.
void ew_take_edge(const ivec2 node, const ivec2 along, inout vec4 difference, inout vec4 middle)
{
    vec4 nodes[6] = ew_edge_nodes(node, along);
    difference = max(difference, ew_fourth_difference(nodes[0], nodes[1], nodes[2], nodes[3], nodes[4]));
    difference = max(difference, ew_fourth_difference(nodes[1], nodes[2], nodes[3], nodes[4], nodes[5]));
    middle += 0.5 * ew_edge_middle(nodes) - 0.125 * (nodes[2] + nodes[3]);
}

// The largest error that is to be expected.
vec4 ew_interpolation_error(const ivec2 first, const int stride)
{
    ivec2 right_step = ivec2(stride, 0), up_step = ivec2(0, stride);
    vec4 difference = vec4(0.0), middle = vec4(0.0);
    ew_take_edge(first, right_step, difference, middle);
    ew_take_edge(first + up_step, right_step, difference, middle);
    ew_take_edge(first, up_step, difference, middle);
    ew_take_edge(first + right_step, up_step, difference, middle);
    return max(EW_ERROR_OF_DIFFERENCE * difference, EW_ERROR_OF_SURPLUS * abs(ew_middle_node(first, stride) - middle));
}

// The largest field at a patch's corners.
float ew_field(const ivec2 first, const int stride)
{
    float most = 0.0;
    for (int i = 0; i < 4; ++i)
        most = max(most, texelFetch(ew_field_texture, first + stride * ivec2(i & 1, i >> 1), 0).r);
    return most;
}

#ifdef EW_DEPTH
#ifdef EW_DEPTH_MULTISAMPLE
#define EW_SAMPLE_COUNT ew_samples.y
#define EW_WINDOW_DEPTH(place, i) ew_window_depth(place, i)
#else
#define EW_SAMPLE_COUNT 1
#define EW_WINDOW_DEPTH(place, i) ew_window_depth(place)
#endif

// Where there is no surface, view depth is infinite, and differences would be no numbers.
float ew_finite_depth(const ivec2 place, const int i)
{
    float depth = EW_WINDOW_DEPTH(place, i);
    return depth < 1e30 ? depth : 1e30;
}

// The surfaces of a patch, along the rays and in ray space.
struct ew_relief {
    float step;  // how far they are off the plane through the patch's corners
    vec4 apart;  // how much farther apart the samples of a pixel are than on that plane, in each quarter of the patch
    float width; // how wide a cell is there
};

// Looks at `count` x `count` pixels that are `pitch` apart, and at those beside them.
ew_relief ew_find_relief(const ivec2 first_pixel, const int count, const int pitch)
{
    ivec2 origin = ew_grid.viewport.xy;
    ivec2 last = ew_grid.viewport.zw - 1;
    ivec2 first = min(first_pixel, last);
    ivec2 end = min(first_pixel + count * pitch, last);
    vec2 size = vec2(max(end - first, 1));
    float d00 = ew_finite_depth(origin + first, 0);
    float d10 = ew_finite_depth(origin + ivec2(end.x, first.y), 0);
    float d01 = ew_finite_depth(origin + ivec2(first.x, end.y), 0);
    float d11 = ew_finite_depth(origin + end, 0);
    float off = 0.0, nearest = d00, farthest = d00;
    vec4 apart = vec4(0.0);
    // Samples of a pixel are less than a pixel apart, and so are their depths on the plane.
    vec2 rise = max(abs(vec2(d10 - d00, d01 - d00)), abs(vec2(d11 - d01, d11 - d10))) / size;
    bool are_numbers = true;
    for (int y = 0; y <= count; ++y)
        for (int x = 0; x <= count; ++x) {
            ivec2 place = min(first + pitch * ivec2(x, y), last);
            vec2 part = vec2(place - first) / size;
            float plane = mix(mix(d00, d10, part.x), mix(d01, d11, part.x), part.y);
            float first_depth = ew_finite_depth(origin + place, 0);
            bvec2 is_upper = greaterThanEqual(2 * ivec2(x, y), ivec2(count));
            vec2 columns = is_upper.x ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
            vec4 quarter = is_upper.y ? vec4(0.0, 0.0, columns) : vec4(columns, 0.0, 0.0);
            for (int i = 0; i < EW_SAMPLE_COUNT; ++i) {
                float depth = ew_finite_depth(origin + place, i);
                float raw = EW_WINDOW_DEPTH(origin + place, i);
                off = max(off, abs(depth - plane));
                apart = max(apart, quarter * (abs(depth - first_depth) - (rise.x + rise.y)));
                nearest = min(nearest, depth);
                farthest = max(farthest, depth);
                are_numbers = are_numbers && (floatBitsToInt(raw) & 0x7fffffff) <= 0x7f800000;
            }
        }
    vec2 pixel = vec2(origin + first) + 0.5 - ew_frame.pixel_center.xy;
    vec2 ends = vec2(ew_end_of_ray(ew_parameter_of_depth(pixel, nearest)), ew_end_of_ray(ew_parameter_of_depth(pixel, farthest)));
    float slope = max(ew_parameter_slope(pixel, nearest), ew_parameter_slope(pixel, farthest));
    float most = are_numbers ? abs(ends.y - ends.x) : 1e30;
    float width = float(EW_CELL_SIZE) * length(ew_frame.ray_up.xy + min(ends.x, ends.y) * ew_frame.ray_up.zw);
    return ew_relief(min(most, slope * off * ew_span()), min(vec4(most), slope * apart * ew_span()), width);
}

// Whether a step along the ray changes next to nothing. The field is known on the surfaces of the nodes, so a step that is wider than a
// cell always counts.
bool ew_is_flat(const float step, const float width, const float field, const float allowed)
{
    return step == 0.0 || (step < width && step * field <= allowed);
}
#endif

bool ew_are_cells_smooth(const ivec2 block)
{
    ivec2 last = (ew_grid.viewport.zw - 1) / EW_CELL_SIZE;
    bool are_smooth = true;
    for (int y = 0; y < EW_BLOCK_CELLS; ++y)
        for (int x = 0; x < EW_BLOCK_CELLS; ++x) {
            ivec2 cell = min(block * EW_BLOCK_CELLS + ivec2(x, y), last);
            are_smooth = are_smooth && ew_read_class(ew_cell_texture, cell) == EW_SMOOTH;
        }
    return are_smooth;
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 first = ew_first_node(place, ew_stride);
    float peak = texelFetch(ew_peak_texture, ivec2(0), 0).a;
    float least = min(min(ew_node(first, ew_stride, 0, 0).a, ew_node(first, ew_stride, 1, 0).a),
                      min(ew_node(first, ew_stride, 0, 1).a, ew_node(first, ew_stride, 1, 1).a));
    float allowed = ew_grid.tolerance.x * max(least, ew_grid.tolerance.y * peak);
    vec4 error = ew_interpolation_error(first, ew_stride);
    float field = ew_field(first, ew_stride);
    bool is_smooth = max(max(error.r, error.g), max(error.b, error.a)) <= allowed && field < EW_UNRESOLVED;
    int torn = 0;
#ifdef EW_DEPTH
    bool is_cell = ew_stride == 1;
    ew_relief relief = ew_find_relief(place * ew_stride * EW_CELL_SIZE, is_cell ? EW_CELL_SIZE : ew_stride, is_cell ? 1 : EW_CELL_SIZE);
    is_smooth = is_smooth && ew_is_flat(relief.step, relief.width, field, allowed);
    for (int i = 0; i < 4; ++i)
        if (!ew_is_flat(relief.apart[i], relief.width, field, allowed)) torn |= 1 << i;
#endif
    if (ew_stride > 1) is_smooth = is_smooth && ew_are_cells_smooth(place);
    int patch_class = is_smooth ? EW_SMOOTH : torn == 0 ? EW_ROUGH : torn;
#if defined(EW_LISTS) && !defined(EW_LUMINANCE)
    int row = ew_find_tile_row(place * ew_stride * EW_CELL_SIZE);
    if (ew_are_lists_empty(row, 0, EW_LIST_COUNT)) patch_class = EW_DARK;
#endif
    ew_class = vec4(float(patch_class) / 255.0);
}
