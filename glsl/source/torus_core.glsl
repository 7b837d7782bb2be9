// The core of a torus, in which the field is constant. Without a reach, each side of the ray is taken to have one piece of core;
// docs/method.md, section 5, says what a second one costs.

float ew_torus_distance_squared(const ew_torus_side side, const float x)
{
    float from_axis = sqrt(max(side.from_axis2 + x * (2.0 * side.outward + side.across2 * x), 0.0));
    float height = side.height + side.height_slope * x;
    return ew_square(from_axis - side.radius) + height * height;
}

// A first guess of how far the core's edges are from the closest approach. At distance epsilon from the torus its farthest
// point is about 2 radius + epsilon away, and the product of the two distances is direction2 |x - own_zero| |x - other_zero|.
float ew_guess_torus_edge(const ew_torus_ray ray, const ew_torus_zeros zeros, const float radius, const float epsilon)
{
    float product = epsilon * (2.0 * radius + epsilon);
    float root2 = dot(zeros.root, zeros.root);
    return product / (sqrt(root2) + sqrt(root2 + product * ray.direction2));
}

// About where the ray is nearest to the torus: a step of Newton's method, from own_zero, towards the minimum of
// |x - own_zero| |x - other_zero|.
float ew_nearest_to_torus(const ew_torus_side side)
{
    float apart = side.own_zero.x - side.other_zero.x;
    float own2 = side.own_zero.y * side.own_zero.y;
    float pull = own2 * apart / max(apart * apart + side.other_zero.y * side.other_zero.y + own2, 1e-30);
    return clamp(side.own_zero.x - pull, 0.0, side.end);
}

#ifndef EW_REACH
// One step of Newton's method from both `edges`, relative to `nearest`, towards squared distance epsilon2. A step at most
// doubles the way from `nearest` and at most takes three quarters of it off, since the squared distance is no parabola where
// the ray runs along the torus. `room` bounds the edges.
vec2 ew_step_to_torus_edges(const ew_torus_side side, const float epsilon2, const float nearest, const vec2 edges,
                            const vec2 room)
{
    vec2 x = nearest + edges;
    vec2 outward = side.outward + side.across2 * x;
    vec2 from_axis = sqrt(side.from_axis2 + x * (side.outward + outward));
    vec2 beyond_radius = from_axis - side.radius;
    vec2 height = side.height + side.height_slope * x;
    // Excess and slope are both multiplied by from_axis, which saves the slope a division.
    vec2 excess = (beyond_radius * beyond_radius + height * height - epsilon2) * from_axis;
    vec2 slope = 2.0 * abs(beyond_radius * outward + height * side.height_slope * from_axis);
    vec2 from_nearest = abs(edges);
    from_nearest -= clamp(excess / max(slope, 1e-30), -from_nearest, 0.75 * from_nearest);
    return clamp(vec2(-1.0, 1.0) * from_nearest, room.xx, room.yy);
}

// About where a ray that is outside of the core at the cut comes into it close behind, if it does before its height has changed much;
// 1e30 otherwise. Newton's method finds no slope at the cut to start with.
float ew_torus_edge_at_cut(const ew_torus_side side, const float epsilon2)
{
    float inward = sqrt(max(epsilon2 - side.height * side.height, 0.0));
    float from_axis = side.radius - inward;
    float growth2 = max(from_axis * from_axis - side.from_axis2, 0.0);
    float x = growth2 / max(side.outward + sqrt(side.outward * side.outward + side.across2 * growth2), 1e-30);
    return abs(side.height_slope) * max(x, from_axis) < 0.1 * inward ? x : 1e30;
}

// Where the ray enters and leaves the core; side.end twice if it does not. An error of an edge counts by its square, because
// the integrand is continuous there. distance2_at_cut is the squared distance at x = 0.
vec2 ew_torus_core(const ew_torus_side side, const float distance2_at_cut, const float edge_guess, const float epsilon2)
{
    float nearest = ew_nearest_to_torus(side);
    bool is_entered = ew_torus_distance_squared(side, nearest) < epsilon2;
    // Otherwise the ray may be in the core at the cut, and the core may go on to the other side.
    nearest = is_entered ? nearest : 0.0;
    is_entered = is_entered || distance2_at_cut < epsilon2;
    vec2 room = vec2(-nearest, side.end - nearest);
    vec2 edges = clamp(vec2(-edge_guess, edge_guess), room.xx, room.yy);
    float at_cut = ew_torus_edge_at_cut(side, epsilon2);
    bool is_close = distance2_at_cut > epsilon2 && nearest + edges.x <= 0.1 * nearest && at_cut < 0.5 * nearest;
    edges.x = is_close ? at_cut - nearest : edges.x;
    // Where no ray of a group enters the core, a software rasteriser is done after the first step.
    int steps = is_entered ? 4 : 1;
    if (EW_IS_NEEDED(is_entered)) {
        int i = 0;
        do {
            edges = ew_step_to_torus_edges(side, epsilon2, nearest, edges, room);
        } while (++i < steps);
    }
    edges.x = is_close ? min(edges.x, 3.0 * at_cut - nearest) : edges.x;
    return is_entered ? nearest + edges : vec2(side.end);
}
#endif

// The integral over the core of 1 / (epsilon depth^2), exact but for rounding.
float ew_integrate_torus_core(const ew_torus_side side, const vec2 core, const float epsilon)
{
#ifdef EW_WORLD
    return (core.y - core.x) / epsilon;
#else
    return (core.y - core.x) /
           (epsilon * (side.depth + side.depth_slope * core.x) * (side.depth + side.depth_slope * core.y));
#endif
}
