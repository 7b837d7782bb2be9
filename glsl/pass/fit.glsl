// Fits a patch's polynomial to nodes: Coons' patch (linear blending) between the cubics along its four edges, which have the nodes' values
// and slopes (Hermite). It is continuous from patch to patch of one size. What linear blending leaves out, f_xxyy / 4 x (1 - x) y (1 - y),
// is added with the mean of the mixed differences at the corners. The error falls as the fourth power of the patch's width.

// The coefficients of x, x^2 and x^3 of the cubic between the third and the fourth of six nodes in a row. The slopes are exact for
// polynomials of fourth degree.
void ew_fit_edge(vec4 nodes[6], out vec4 edge[3])
{
    vec4 slope = (8.0 * (nodes[3] - nodes[1]) - (nodes[4] - nodes[0])) / 12.0;
    vec4 last_slope = (8.0 * (nodes[4] - nodes[2]) - (nodes[5] - nodes[1])) / 12.0;
    vec4 rise = nodes[3] - nodes[2];
    edge = vec4[3](slope, 3.0 * rise - 2.0 * slope - last_slope, slope + last_slope - 2.0 * rise);
}

// The sum, over the two nodes x = 0 and x = 1 of a row, of the second differences.
vec4 ew_second_differences(ivec2 first, int stride, int row)
{
    return ew_node(first, stride, -1, row) - ew_node(first, stride, 0, row) - ew_node(first, stride, 1, row)
           + ew_node(first, stride, 2, row);
}

void ew_fit(ivec2 first, int stride)
{
    vec4 bottom[6], top[6], left[6], right[6];
    for (int i = 0; i < 6; ++i) {
        bottom[i] = ew_node(first, stride, i - 2, 0);
        top[i] = ew_node(first, stride, i - 2, 1);
        left[i] = ew_node(first, stride, 0, i - 2);
        right[i] = ew_node(first, stride, 1, i - 2);
    }
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
    ew_coefficients[12] = (ew_second_differences(first, stride, -1) - ew_second_differences(first, stride, 0)
                           - ew_second_differences(first, stride, 1) + ew_second_differences(first, stride, 2)) / 16.0;
}
