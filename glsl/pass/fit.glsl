// Fits a patch's polynomial to nodes: Coons' patch (linear blending) between the cubics along its four edges, which have the nodes' values
// and slopes (Hermite). It is continuous from patch to patch of one size. A multiple of x (1 - x) y (1 - y) is added, so that the
// node in the middle has its value, too. The error falls as the fourth power of the patch's width.

// The coefficients of x, x^2 and x^3 of an edge.
void ew_fit_edge(vec4 nodes[6], out vec4 edge[3])
{
    vec4 slope = ew_first_slope(nodes);
    vec4 last_slope = ew_last_slope(nodes);
    vec4 rise = nodes[3] - nodes[2];
    edge = vec4[3](slope, 3.0 * rise - 2.0 * slope - last_slope, slope + last_slope - 2.0 * rise);
}

void ew_fit(const ivec2 first, const int stride)
{
    ivec2 right_step = ivec2(stride, 0), up_step = ivec2(0, stride);
    vec4 bottom[6] = ew_edge_nodes(first, right_step), top[6] = ew_edge_nodes(first + up_step, right_step);
    vec4 left[6] = ew_edge_nodes(first, up_step), right[6] = ew_edge_nodes(first + right_step, up_step);
    vec4 b[3], t[3], l[3], r[3];
    ew_fit_edge(bottom, b);
    ew_fit_edge(top, t);
    ew_fit_edge(left, l);
    ew_fit_edge(right, r);
    vec4 twist = top[3] - bottom[3] - top[2] + bottom[2];
    ew_coefficients[0] = bottom[2];
    ew_coefficients[1] = b[0];
    ew_coefficients[2] = b[1];
    ew_coefficients[3] = b[2];
    ew_coefficients[4] = l[0];
    ew_coefficients[5] = (t[0] - b[0]) + (r[0] - l[0]) - twist;
    ew_coefficients[6] = t[1] - b[1];
    ew_coefficients[7] = t[2] - b[2];
    ew_coefficients[8] = l[1];
    ew_coefficients[9] = r[1] - l[1];
    ew_coefficients[10] = l[2];
    ew_coefficients[11] = r[2] - l[2];
    vec4 middle = 0.5 * (ew_edge_middle(bottom) + ew_edge_middle(top) + ew_edge_middle(left) + ew_edge_middle(right))
                  - 0.25 * (bottom[2] + bottom[3] + top[2] + top[3]);
    ew_coefficients[12] = 16.0 * (ew_middle_node(first, stride) - middle);
}
