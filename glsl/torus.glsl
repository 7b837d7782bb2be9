// The integral over a segment of 1 / distance to a circle, equation (7).

// A circle and a ray: at s, the ray is |offset + s across| = sqrt(from_axis2 + across2 x^2) away from the circle's axis, where
// x = s - s_axis, and start_height + s climb = height + climb x above its plane. Where the ray runs nearly along the axis, s_axis
// is far away, and x has few digits.
struct ew_ring {
    vec3 offset;
    vec3 across;
    float start_height;
    float radius;
    float s_axis;
    float from_axis2;
    float across2;
    float height;
    float climb;
};

float ew_ring_distance_squared(ew_ring ring, float s)
{
    return ew_square(length(ring.offset + s * ring.across) - ring.radius) + ew_square(ring.start_height + s * ring.climb);
}

float ew_reciprocal_difference(ew_ring ring, ew_passage passage, float s, out float weight_piece)
{
    weight_piece = 0.0;
    return ew_reciprocal_difference(passage, s, ew_ring_distance_squared(ring, s), 1.0);
}

#ifdef EW_WEIGHTS
float ew_next_knot(ew_ring ring, float from_piece, float to_piece)
{
    return 1e9; // a torus has no weights
}
#endif

// The closest approaches before and behind the axis (x and y), as x = s - s_axis; on the wrong side of 0 where there is none.
// There the slope of d^2 / 2, k (x - m) - radius across2 x / sqrt(from_axis2 + across2 x^2), is 0: a straight line meets a sigmoid.
// Newton's method, started where the line meets the sigmoid's limits, comes down a convex function and cannot miss.
vec2 ew_ring_closest_approaches(ew_ring ring, out vec2 curvature)
{
    float k = ring.across2 + ring.climb * ring.climb;
    float m = -ring.height * ring.climb / k;
    float pull = ring.radius * ring.across2;
    vec2 x = m + vec2(-1.0, 1.0) * ring.radius * sqrt(ring.across2) / k;
    for (int i = 0; i < 4; ++i) {
        vec2 inverse = inversesqrt(max(ring.from_axis2 + ring.across2 * x * x, 1e-30));
        curvature = k - pull * ring.from_axis2 * inverse * inverse * inverse;
        vec2 step_length = (k * (x - m) - pull * x * inverse) / max(curvature, 1e-3 * k);
        x -= step_length;
        x = vec2(min(x.x, 0.0), max(x.y, 0.0));
    }
    // Where the ray grazes the circle the curvature vanishes, and a parabola with so little would be far too flat further on.
    curvature = clamp(curvature, 0.1 * k, k);
    return x;
}

float ew_integrate_rest(ew_ring shape, ew_passage passage, float from, float to, float allowance);

float ew_integrate_torus(ew_segment segment, ew_torus_block torus)
{
    vec3 axis = torus.axis.xyz;
    vec3 offset = segment.origin - torus.center.xyz;
    float height = dot(offset, axis);
    ew_ring ring;
    ring.radius = torus.axis.w;
    ring.climb = dot(segment.direction, axis);
    vec3 across = segment.direction - ring.climb * axis;
    ring.across2 = max(ew_length_squared(across), 1e-12);
    offset -= height * axis;
    ring.offset = offset;
    ring.across = across;
    ring.start_height = height;
    ring.s_axis = -dot(offset, across) / ring.across2;
    ring.from_axis2 = ew_length_squared(offset + ring.s_axis * across);
    ring.height = height + ring.s_axis * ring.climb;

    vec2 curvature;
    vec2 x = ew_ring_closest_approaches(ring, curvature);
    // Behind the axis another half of the circle is nearest. Where a half has no closest approach of its own, the other's serves.
    float x_near = x.x < 0.0 ? x.x : x.y;
    float x_far = x.y > 0.0 ? x.y : x.x;
    float k_near = x.x < 0.0 ? curvature.x : curvature.y;
    float k_far = x.y > 0.0 ? curvature.y : curvature.x;
    float s_axis = clamp(ring.s_axis, 0.0, segment.end);
    float sum = 0.0;
    float from = 0.0;
    float to = s_axis > 0.0 ? s_axis : segment.end;
    bool is_near = s_axis > 0.0;
    for (int half_circle = 0; half_circle < 2; ++half_circle) {
        float passing = is_near ? x_near : x_far;
        float distance_squared = ew_ring_distance_squared(ring, ring.s_axis + passing);
        ew_passage passage = ew_passage(false, true, distance_squared, is_near ? k_near : k_far, ring.s_axis + passing, 1.0);
        sum += ew_integrate_line_distance(passage.b2, passage.k, passage.s0, from, to);
        sum += ew_integrate_rest(ring, passage, from, to, ew_frame.decay.z * sum);
        if (to >= segment.end) break;
        from = to;
        to = segment.end;
        is_near = false;
    }
    return sum;
}
