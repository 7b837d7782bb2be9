// The cubic along the edge of a patch, between the third and the fourth of six nodes in a row. It has the nodes' values and slopes
// (Hermite); the slopes are exact for polynomials of fourth degree.

// The slopes at both ends.
vec4 ew_first_slope(vec4 nodes[6])
{
    return (8.0 * (nodes[3] - nodes[1]) - (nodes[4] - nodes[0])) / 12.0;
}

vec4 ew_last_slope(vec4 nodes[6])
{
    return (8.0 * (nodes[4] - nodes[2]) - (nodes[5] - nodes[1])) / 12.0;
}

// The cubic in the middle of the edge.
vec4 ew_edge_middle(vec4 nodes[6])
{
    return 0.5 * (nodes[2] + nodes[3]) + 0.125 * (ew_first_slope(nodes) - ew_last_slope(nodes));
}

// Six nodes in a row through an edge of a patch that begins at a node; the next one is `along` it.
vec4[6] ew_edge_nodes(ivec2 node, ivec2 along)
{
    return vec4[6](texelFetch(ew_node_texture, node - 2 * along, 0), texelFetch(ew_node_texture, node - along, 0),
                   texelFetch(ew_node_texture, node, 0), texelFetch(ew_node_texture, node + along, 0),
                   texelFetch(ew_node_texture, node + 2 * along, 0), texelFetch(ew_node_texture, node + 3 * along, 0));
}
