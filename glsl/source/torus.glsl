// A torus, equation (7): the circle of a radius about an axis.

float ew_distance_squared(ew_torus_block torus, vec3 position, out float weight)
{
    vec3 difference = position - torus.center.xyz;
    float height = dot(difference, torus.axis.xyz);
    float from_axis = length(difference - height * torus.axis.xyz);
    weight = 1.0;
    return ew_square(from_axis - torus.axis.w) + height * height;
}

#ifndef EW_SAMPLING
// The integral over a segment of 1 / distance to a circle, equation (7); docs/method.md, section 5, has the derivation.

// A ray, from the place where it is nearest to the circle's axis towards one of its ends. x behind that place, it is
// sqrt(from_axis2 + x (2 leaving + across2 x)) away from the axis and height + climb x above the circle's plane, and its depth is
// depth + toward x. (leaving is 0 but where the nearest place would lie outside of the segment.)
//
// The distance times that to the circle's farthest point is growth |x - own| |x - other|, with complex zeros: at `own` the
// distance vanishes, on this side of the axis if it does on any.
struct ew_ring_side {
    float radius;
    float across2;
    float from_axis2;
    float leaving;
    float height;
    float climb;
    float growth;
    float depth;
    float toward; // 1: away from the eye, -1: towards it
    float end;
    vec2 own;
    vec2 other;
};

// More than any ray takes: panels grow by factors.
const int EW_MAX_RING_PANELS = 40;

vec2 ew_complex_product(vec2 a, vec2 b)
{
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// The square root whose real part is positive.
vec2 ew_complex_root(vec2 z)
{
    float larger = sqrt(max(0.5 * (length(z) + abs(z.x)), 1e-30));
    float smaller = 0.5 * z.y / larger;
    return z.x >= 0.0 ? vec2(larger, smaller) : vec2(abs(smaller), z.y < 0.0 ? -larger : larger);
}

vec2 ew_ring_distance_squared(ew_ring_side side, vec2 x)
{
    vec2 from_circle = sqrt(max(side.from_axis2 + x * (2.0 * side.leaving + side.across2 * x), 0.0)) - side.radius;
    vec2 height = side.height + side.climb * x;
    return from_circle * from_circle + height * height;
}

// Where the ray enters and leaves the core, in which the field is constant; twice side.end if it does not. distance2_at_axis is
// the squared distance at x = 0, and reach is about how far the edges are from the closest approach.
vec2 ew_ring_core(ew_ring_side side, float distance2_at_axis, float reach)
{
    float epsilon2 = ew_square(ew_frame.decay.y);
    // The closest approach is near the minimum of |x - own| |x - other|, or else at the axis, where the core may go on to the
    // other side.
    float apart = side.own.x - side.other.x;
    float own2 = side.own.y * side.own.y;
    float pull = own2 * apart / max(apart * apart + side.other.y * side.other.y + own2, 1e-30);
    float nearest = clamp(side.own.x - pull, 0.0, side.end);
    bool is_entered = ew_ring_distance_squared(side, vec2(nearest)).x < epsilon2;
    nearest = is_entered ? nearest : 0.0;
    is_entered = is_entered || distance2_at_axis < epsilon2;
    // From there to the edges, Newton's method for the squared distance. It is no parabola where the ray runs along the circle.
    // (Where no ray of a group enters, a software rasteriser is done after the first step.)
    vec2 room = vec2(-nearest, side.end - nearest);
    vec2 edges = clamp(vec2(-reach, reach), room.xx, room.yy);
    int steps = is_entered ? 4 : 1;
    if (EW_IS_NEEDED(is_entered)) {
        int i = 0;
        do {
            vec2 x = nearest + edges;
            vec2 leaving = side.leaving + side.across2 * x;
            vec2 from_axis = sqrt(side.from_axis2 + x * (side.leaving + leaving));
            vec2 from_circle = from_axis - side.radius;
            vec2 height = side.height + side.climb * x;
            vec2 excess = (from_circle * from_circle + height * height - epsilon2) * from_axis;
            vec2 slope = 2.0 * abs(from_circle * leaving + height * side.climb * from_axis);
            vec2 from_nearest = abs(edges);
            from_nearest -= clamp(excess / max(slope, 1e-30), -from_nearest, 0.75 * from_nearest);
            edges = clamp(vec2(-1.0, 1.0) * from_nearest, room.xx, room.yy);
        } while (++i < steps);
    }
    return is_entered ? nearest + edges : vec2(side.end);
}

float ew_integrate_ring_core(ew_ring_side side, vec2 core)
{
    return (core.y - core.x) / (ew_frame.decay.y * (side.depth + side.toward * core.x) * (side.depth + side.toward * core.y));
}

// side.growth times the integral over x in [from, from + size] of 1 / (distance depth^2), where other zeros than side.own are
// `clearance` before `from`.
//
// The panel is mapped to t in [-1, 1] by x - from = scale (1 + t) / (1 - m t), scale = size (1 - m) / 2. Multiplied by 1 - m t,
// whatever is a polynomial in x is one in t. Then the integrand is one that is smooth, over |t - own|: at six nodes, the former
// is fitted by a polynomial, whose product with the latter has an integral in closed form.
float ew_integrate_ring_panel(ew_ring_side side, float from, float size, float clearance)
{
    // m makes what is singular before and beyond the panel equally far away: the other zero, and depth = 0, which on the way away
    // from the eye is before the panel, too, and seen through infinity beyond it.
    float depth = side.depth + side.toward * from;
    bool is_nearing = side.toward < 0.0;
    float before = is_nearing ? clearance : min(clearance, depth);
    float beyond = is_nearing ? depth - size : max(clearance, depth);
    float from_before = size + 2.0 * before;
    float to_beyond = is_nearing ? size + 2.0 * beyond : -size - 2.0 * beyond;
    float mean = 4.0 * sqrt(before * (before + size) * beyond * (beyond + size));
    float m = size * (to_beyond - from_before) / (from_before * to_beyond - size * size + (is_nearing ? mean : -mean));
    float m_complement = 1.0 - m * m;
    float scale = 0.5 * size * (1.0 - m);

    // The own zero's t.
    vec2 own = vec2(2.0 * (side.own.x - from) - size, 2.0 * side.own.y);
    vec2 own_scale = vec2(size + m * own.x, m * own.y);
    float own_scale2 = dot(own_scale, own_scale);
    float zero = ((own.x + m * size) * own_scale.x + own.y * own_scale.y) / own_scale2;
    float zero_height2 = ew_square(max(abs(own.y) * size * m_complement / own_scale2, 1e-9));
    float zero2 = zero * zero + zero_height2;

    // The integrals of t^i / |t - zero|.
    vec2 across = abs(vec2(1.0 + zero, 1.0 - zero));
    vec2 r = sqrt(across * across + zero_height2);
    vec2 reach = r + across;
    float ratio = abs(zero) < 1.0 ? reach.x * reach.y / zero_height2 : max(reach.x, reach.y) / min(reach.x, reach.y);
    float r_sum = r.y + r.x;
    float r_difference = r.y - r.x;
    float moment0 = 0.69314718 * log2(ratio);
    float moment1 = r_difference + zero * moment0;
    float moment2 = 0.5 * (r_sum + 3.0 * zero * moment1 - zero2 * moment0);
    float moment3 = (1.0 / 3.0) * (r_difference + 5.0 * zero * moment2 - 2.0 * zero2 * moment1);
    float moment4 = 0.25 * (r_sum + 7.0 * zero * moment3 - 3.0 * zero2 * moment2);
    float moment5 = 0.2 * (r_difference + 9.0 * zero * moment4 - 4.0 * zero2 * moment3);

    // Gauss's nodes, +nodes and -nodes, and Lagrange's polynomials for their squares. If the zero is far away, where those moments
    // would be differences of large numbers, Gauss's weights do.
    const vec3 nodes = vec3(0.23861919, 0.66120939, 0.93246951);
    const vec3 nodes2 = nodes * nodes;
    const mat3 lagrange = mat3(1.23030422, -0.301171601, 0.0708673784, -4.22902436, 5.63573565, -1.40671129, 3.23642249, -6.08322688,
                               2.84680439);
    bool is_far = zero2 > 4.0;
    vec3 even = is_far ? vec3(0.46791393, 0.36076157, 0.17132449) : 0.5 * (lagrange * vec3(moment0, moment2, moment4));
    vec3 odd = is_far ? vec3(0.0) : (0.5 / nodes) * (lagrange * vec3(moment1, moment3, moment5));

    // Everything at the nodes, as an even and an odd part.
    vec3 shrink_right = 1.0 - m * nodes;
    vec3 shrink_left = 1.0 + m * nodes;
    float from_axis2 = side.from_axis2 + from * (2.0 * side.leaving + side.across2 * from);
    float leaving = (side.leaving + side.across2 * from) * scale;
    float across2 = side.across2 * scale * scale;
    vec3 even_part = (from_axis2 + 2.0 * leaving + across2) + (from_axis2 * m * m - 2.0 * leaving * m + across2) * nodes2;
    vec3 odd_part = (2.0 * (across2 - from_axis2 * m + leaving * (1.0 - m))) * nodes;
    vec3 far_right = sqrt(max(even_part + odd_part, 0.0)) + side.radius * shrink_right;
    vec3 far_left = sqrt(max(even_part - odd_part, 0.0)) + side.radius * shrink_left;
    float height = side.height + side.climb * from;
    float climb = side.climb * scale;
    odd_part = (climb - height * m) * nodes;
    vec3 height_right = height + climb + odd_part;
    vec3 height_left = height + climb - odd_part;
    vec2 other = 2.0 * vec2(from - side.other.x, side.other.y);
    vec2 other_constant = vec2(other.x + 2.0 * scale, other.y);
    vec2 other_slope = vec2(2.0 * scale - other.x * m, -other.y * m);
    even_part = dot(other_constant, other_constant) + dot(other_slope, other_slope) * nodes2;
    odd_part = 2.0 * dot(other_constant, other_slope) * nodes;
    vec3 divisor_right = even_part + odd_part;
    vec3 divisor_left = even_part - odd_part;
    float deepening = side.toward * scale;
    odd_part = (deepening - depth * m) * nodes;
    vec3 depth_right = depth + deepening + odd_part;
    vec3 depth_left = depth + deepening - odd_part;
    depth_right *= depth_right;
    depth_left *= depth_left;
    even_part = zero2 + nodes2;
    odd_part = 2.0 * zero * nodes;
    divisor_right *= is_far ? even_part - odd_part : vec3(1.0);
    divisor_left *= is_far ? even_part + odd_part : vec3(1.0);
    divisor_right *= depth_right * depth_right;
    divisor_left *= depth_left * depth_left;
    vec3 right = shrink_right * sqrt((far_right * far_right + height_right * height_right) / divisor_right);
    vec3 left = shrink_left * sqrt((far_left * far_left + height_left * height_left) / divisor_left);
    ew_evaluation_count += 6;
    return 2.0 * size * m_complement * inversesqrt(own_scale2) * (dot(even, right + left) + dot(odd, right - left));
}

float ew_integrate(ew_segment segment, ew_torus_block torus, float others)
{
    vec3 axis = torus.axis.xyz;
    float radius = torus.axis.w;
    vec3 offset = segment.origin - torus.center.xyz;
    float height = dot(offset, axis);
    float climb = dot(segment.direction, axis);
    vec3 across = segment.direction - climb * axis;
    offset -= height * axis;
    float across2 = max(ew_length_squared(across), 1e-12);
    float growth = across2 + climb * climb;
    float start_leaving = dot(offset, across);
    float s_axis = -start_leaving / across2;
    float s = clamp(s_axis, 0.0, segment.end);
    float leaving = s == s_axis ? 0.0 : start_leaving + s * across2;
    float moment2 = ew_length_squared(cross(offset, across));
    offset += s * across;
    height += s * climb;
    float from_axis2 = ew_length_squared(offset);

    // The zeros x of growth x^2 - 2 half x = product, of which one comes from a sum and the other by division.
    float from_axis = sqrt(from_axis2);
    vec2 product = vec2((radius - from_axis) * (radius + from_axis) - height * height, 2.0 * radius * height);
    vec2 root = ew_complex_root(vec2(across2 * (radius * radius - height * height) + 2.0 * climb * leaving * height
                                         - climb * climb * from_axis2 - moment2,
                                     2.0 * radius * (across2 * height - climb * leaving)));
    vec2 half_sum = vec2(-climb * height - leaving, climb * radius);
    bool is_behind = half_sum.x < 0.0;
    vec2 larger = is_behind ? root - half_sum : root + half_sum;
    vec2 smaller = ew_complex_product(product, vec2(larger.x, -larger.y)) / max(dot(larger, larger), 1e-30);
    larger /= growth;
    vec2 plus = is_behind ? smaller : larger;
    vec2 minus = is_behind ? -larger : -smaller;

    // It is the distance that vanishes, and not the one to the farthest point, where radius + i height has a positive real part.
    bool is_far_own = radius >= climb * plus.y;
    bool is_near_own = radius >= climb * minus.y;
    float depth = s + ew_frame.decay.x;
    ew_ring_side far = ew_ring_side(radius, across2, from_axis2, max(leaving, 0.0), height, climb, growth, depth, 1.0,
                                    segment.end - s, is_far_own ? plus : minus, is_far_own ? minus : plus);
    ew_ring_side near = ew_ring_side(radius, across2, from_axis2, max(-leaving, 0.0), height, -climb, growth, depth, -1.0, s,
                                     -(is_near_own ? minus : plus), -(is_near_own ? plus : minus));
    // At distance epsilon from the circle its farthest point is about 2 radius + epsilon away, and the product of both distances
    // is that of the distances to the zeros, times growth.
    float distance2_at_axis = ew_square(from_axis - radius) + height * height;
    float at_edge = ew_frame.decay.y * (2.0 * radius + ew_frame.decay.y);
    float root2 = dot(root, root);
    float reach = at_edge / (sqrt(root2) + sqrt(root2 + at_edge * growth));
    vec2 far_core = ew_ring_core(far, distance2_at_axis, reach);
    vec2 near_core = ew_ring_core(near, distance2_at_axis, reach);
    float cores = ew_integrate_ring_core(far, far_core) + ew_integrate_ring_core(near, near_core);

    // What is before and behind the cores, from the axis outwards, in panels that are no longer than so many times the distance of
    // what is singular around them.
    float error = ew_frame.decay.z;
    float longest = error > 3e-3 ? 8.0 : error > 3e-4 ? 4.0 : 0.6;
    bool is_near = s > 0.0;
    ew_ring_side side = is_near ? near : far;
    vec2 core = is_near ? near_core : far_core;
    float from = core.x > 0.0 ? 0.0 : core.y;
    float stop = core.x > 0.0 ? core.x : side.end;
    float sum = 0.0;
    for (int panel = 0; panel < EW_MAX_RING_PANELS; ++panel) {
        float clearance = max(length(vec2(from - side.other.x, side.other.y)), 1e-6);
        float from_depth = side.depth + side.toward * from;
        float remaining = max(stop - from, 0.0);
        float size = min(longest * clearance, from_depth * (is_near ? longest / (4.0 + longest) : 0.5 * longest));
        bool is_part_done = size >= remaining;
        size = is_part_done ? remaining : size;
        float light = ew_integrate_ring_panel(side, from, max(size, 1e-12), 1.5 * clearance);
        sum += remaining > 0.0 ? light : 0.0;
        bool is_side_done = is_part_done && stop >= side.end;
        if (is_side_done && (!is_near || far.end <= 0.0)) break;

        from = is_part_done ? core.y : from + size;
        stop = is_part_done ? side.end : stop;
        if (is_side_done) {
            is_near = false;
            side = far;
            core = far_core;
            from = core.x > 0.0 ? 0.0 : core.y;
            stop = core.x > 0.0 ? core.x : side.end;
        }
    }
    return cores + sum / growth;
}
#endif
