// A ray beside a torus. Where it is nearest to the torus's axis, the ray is cut into two sides, and on each side the torus's
// distance is a product of factors with known zeros. docs/method.md, section 5, has the derivation.

// The ray in cylindrical coordinates about the axis, with x = s - center:
//
//     squared distance from the axis     from_axis2 + 2 outward x + across2 x^2
//     height above the torus's plane     height + height_slope x
//
// outward is 0, unless the place nearest to the axis lies outside the segment. Then x counts from the segment's end, so that a
// ray along the axis, which is nearest to it nowhere in particular, loses no digits.
struct ew_torus_ray {
    float center;
    float from_axis2;
    float outward;
    float across2;
    float height;
    float height_slope;
    float direction2; // across2 + height_slope^2, the ray's squared speed
    float moment2;    // from_axis2 across2 - outward^2, computed as a cross product
};

// Of the part [from, to] of a segment.
ew_torus_ray ew_make_torus_ray(const ew_segment segment, const ew_torus_block torus, const vec2 part)
{
    vec3 axis = torus.axis.xyz;
    ew_torus_ray ray;
    vec3 offset = segment.origin - torus.center.xyz;
    float start_height = dot(offset, axis);
    ray.height_slope = dot(segment.direction, axis);
    vec3 across = segment.direction - ray.height_slope * axis;
    offset -= start_height * axis;
    ray.across2 = max(ew_length_squared(across), 1e-12);
    ray.direction2 = ray.across2 + ray.height_slope * ray.height_slope;
    float start_outward = dot(offset, across);
    float nearest = -start_outward / ray.across2;
    ray.center = clamp(nearest, part.x, part.y);
    ray.outward = ray.center == nearest ? 0.0 : start_outward + ray.center * ray.across2;
    ray.moment2 = ew_length_squared(cross(offset, across));
    offset += ray.center * across;
    ray.height = start_height + ray.center * ray.height_slope;
    ray.from_axis2 = ew_length_squared(offset);
    return ray;
}

vec2 ew_complex_product(const vec2 a, const vec2 b)
{
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// The square root with the positive real part.
vec2 ew_complex_root(const vec2 z)
{
    float larger = sqrt(max(0.5 * (length(z) + abs(z.x)), 1e-30));
    float smaller = 0.5 * z.y / larger;
    return z.x >= 0.0 ? vec2(larger, smaller) : vec2(abs(smaller), z.y < 0.0 ? -larger : larger);
}

// With `farthest` the distance from the torus's farthest point,
//
//     distance * farthest = direction2 |x - plus| |x - minus|,
//
// where the complex zeros are plus, minus = (half_sum +- root) / direction2.
struct ew_torus_zeros {
    vec2 plus;
    vec2 minus;
    vec2 root;
};

// The zeros of direction2 x^2 - 2 half_sum x - product. One comes from a sum and the other from `product` by division, so that
// neither is a small difference.
ew_torus_zeros ew_find_torus_zeros(const ew_torus_ray ray, const float radius)
{
    float from_axis = sqrt(ray.from_axis2);
    vec2 product = vec2((radius - from_axis) * (radius + from_axis) - ray.height * ray.height, 2.0 * radius * ray.height);
    vec2 root = ew_complex_root(vec2(ray.across2 * (radius * radius - ray.height * ray.height)
                                         + 2.0 * ray.height_slope * (ray.outward * ray.height)
                                         - ray.height_slope * ray.height_slope * ray.from_axis2 - ray.moment2,
                                     2.0 * radius * (ray.across2 * ray.height - ray.height_slope * ray.outward)));
    vec2 half_sum = vec2(-ray.height_slope * ray.height - ray.outward, ray.height_slope * radius);
    bool is_behind = half_sum.x < 0.0;
    vec2 larger = is_behind ? root - half_sum : root + half_sum;
    vec2 smaller = ew_complex_product(product, vec2(larger.x, -larger.y)) / max(dot(larger, larger), 1e-30);
    larger /= ray.direction2;
    return ew_torus_zeros(is_behind ? smaller : larger, is_behind ? -larger : -smaller, root);
}

// One side of the cut, with x counted from the cut outwards, in [begin, end]. The squared distance from the axis and the height are
// polynomials of x as in ew_torus_ray, and depth, s + beta, is depth + depth_slope x.
struct ew_torus_side {
    float radius;
    float from_axis2;
    float outward; // >= 0 if the side has a length
    float across2;
    float height;
    float height_slope;
    float depth;
    float depth_slope; // 1: away from the eye, -1: towards it
    float begin;       // without a reach, 0 or the end of a piece of core
    float end;
    float center; // s of the cut
    vec4 glow;
    vec2 own_zero;     // where the distance vanishes: on this side of the cut if it vanishes on any
    vec2 other_zero;
};

// The side on which s grows by depth_slope x. `ahead` is the zero that lies further in that direction, as a value of s -
// center.
ew_torus_side ew_make_torus_side(const ew_torus_ray ray, const float radius, const vec4 glow, const float depth_slope,
                                 const float end, const vec2 ahead, const vec2 behind)
{
    ew_torus_side side;
    side.radius = radius;
    side.from_axis2 = ray.from_axis2;
    side.outward = depth_slope * ray.outward;
    side.across2 = ray.across2;
    side.height = ray.height;
    side.height_slope = depth_slope * ray.height_slope;
    side.depth = ray.center + ew_beta();
    side.depth_slope = depth_slope;
    side.begin = 0.0;
    side.end = end;
    side.center = ray.center;
    side.glow = glow;
    // At a zero of the distance, and not of `farthest`, the real part of radius + i height is positive.
    bool is_ahead = radius >= ray.height_slope * ahead.y;
    side.own_zero = depth_slope * (is_ahead ? ahead : behind);
    side.other_zero = depth_slope * (is_ahead ? behind : ahead);
    return side;
}
