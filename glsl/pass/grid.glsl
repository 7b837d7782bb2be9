// The grid of adaptive resolution: see layout.glsl. A patch is what is interpolated as one, a cell or a block; its stride is its
// width in cells.

// Where the nodes of a patch lie: its lower left corner in the texture of nodes.
ivec2 ew_first_node(const ivec2 patch_place, const int stride)
{
    return patch_place * stride + EW_NODE_MARGIN;
}

// Classes of patches. Smooth ones are interpolated between their nodes, the others are integrated pixel by pixel: rough ones once a
// pixel, torn ones once for each surface that the samples of a pixel see.
const int EW_SMOOTH = 255;
const int EW_ROUGH = 254;
// Patches that no source can light are not drawn, unless the target's values are replaced.
const int EW_DARK = 253;
// A torn cell's class is which of its quarters are torn, as bits: 1 + 2 for the lower ones, 1 + 4 for the left ones.
const int EW_LAST_TORN = 15;

int ew_read_class(sampler2D classes, const ivec2 place)
{
    return int(255.0 * texelFetch(classes, place, 0).r + 0.5);
}

// The field's value at a node that a source may slip by.
const float EW_UNRESOLVED = 1e30;

#ifdef EW_FIELD
// How long a cell's diagonal is at the ray parameter s, in ray space.
float ew_cell_diagonal(const float s)
{
    vec2 right = ew_frame.ray_right.xy + s * ew_frame.ray_right.zw;
    vec2 up = ew_frame.ray_up.xy + s * ew_frame.ray_up.zw;
    return float(EW_CELL_SIZE) * sqrt(dot(right, right) + dot(up, up));
}
#endif

#ifndef EW_NODE_STAGE
// The light of the nodes: sum B_i color_i, and B as the fourth component; and that of the nodes in the middle of the cells.
uniform sampler2D ew_node_texture;
uniform sampler2D ew_middle_texture;

vec4 ew_node(const ivec2 first, const int stride, const int x, const int y)
{
    return texelFetch(ew_node_texture, first + stride * ivec2(x, y), 0);
}

// The node in the middle of a patch.
vec4 ew_middle_node(const ivec2 first, const int stride)
{
    return stride == 1 ? texelFetch(ew_middle_texture, first, 0) : texelFetch(ew_node_texture, first + stride / 2, 0);
}
#endif
