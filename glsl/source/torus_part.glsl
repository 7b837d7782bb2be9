// The parts of a ray beside a torus on each of which the distance falls up to one place and grows from there on. Only sources with a
// reach need them: see docs/method.md, section 11.
#ifdef EW_REACH

// Half the derivative of the squared distance at x, and half its second derivative. With q the slope of the distance from the axis,
// the first is outward + height height_slope - radius q, and the second direction2 - radius dq/dx.
vec2 ew_torus_slope(ew_torus_ray ray, ew_torus_side side, float x)
{
    float outward = side.outward + side.across2 * x;
    float from_axis2 = max(side.from_axis2 + x * (side.outward + outward), 1e-30);
    float from_axis = sqrt(from_axis2);
    float height = side.height + side.height_slope * x;
    return vec2(outward + height * side.height_slope - side.radius * outward / from_axis,
                ray.direction2 - side.radius * ray.moment2 / from_axis2 / from_axis);
}

// Where the distance is least, beyond what ew_farthest_from_torus finds. The slope is a convex function of x, so Newton's method comes
// down to its last zero from any place between that and `flat`, where it falls no more. The slope is positive from `steep` on, as q
// is at most sqrt(across2).
float ew_nearest_to_torus(ew_torus_ray ray, ew_torus_side side)
{
    float pull = side.radius * sqrt(side.across2) - side.outward - side.height * side.height_slope;
    float steep = max(pull / ray.direction2, 0.0);
    float from_axis2_there = pow(max(side.radius * ray.moment2 / ray.direction2, 1e-30), 0.66666667);
    float discriminant = side.across2 * from_axis2_there - ray.moment2;
    float flat_place = max((sqrt(max(discriminant, 0.0)) - side.outward) / side.across2, 0.0);
    float x = clamp(ew_nearest_to_torus(side), min(flat_place, steep), steep);
    int step = 0;
    do {
        vec2 slope = ew_torus_slope(ray, side, x);
        x = clamp(x - slope.x / max(slope.y, 1e-3 * ray.direction2), 0.0, steep);
    } while (++step < 3);
    return min(x, side.end);
}

// Where the distance, which grows from the cut on, is largest before it falls to `nearest`. With q as a share of its largest value,
// sqrt(across2), the slope is a convex function of q, too: Newton's method from q where x is taken for 0 goes up to its first zero.
float ew_farthest_from_torus(ew_torus_ray ray, ew_torus_side side, float nearest)
{
    float scale = sqrt(ray.moment2) / side.across2;
    float pull = side.radius * sqrt(side.across2);
    float least = side.outward + side.height * side.height_slope;
    float q = min(least / max(pull, 1e-30), 0.999999);
    float x = 0.0;
    int step = 0;
    do {
        float inverse2 = 1.0 / (1.0 - q * q);
        float inverse = sqrt(inverse2);
        x = scale * q * inverse - side.outward / side.across2;
        float slope = least + ray.direction2 * x - pull * q;
        float growth = ray.direction2 * scale * inverse2 * inverse - pull;
        q = clamp(q - slope / min(growth, -0.05 * pull - 1e-30), q, 0.999999);
    } while (++step < 4);
    return clamp(x, 0.0, nearest);
}

// A part of a side, [side.begin, side.end].
struct ew_torus_part {
    ew_torus_side side;
    float nearest;
    float distance2; // the squared distance at `nearest`
    float slope;     // ew_torus_slope there
    float curvature;
};

ew_torus_part ew_make_torus_part(ew_torus_ray ray, ew_torus_side side, float nearest)
{
    nearest = ew_torus_distance_squared(side, side.begin) < ew_torus_distance_squared(side, nearest) ? side.begin : nearest;
    vec2 slope = ew_torus_slope(ray, side, nearest);
    return ew_torus_part(side, nearest, ew_torus_distance_squared(side, nearest), abs(slope.x), max(slope.y, 0.0));
}

float ew_quadratic(vec3 coefficients, float x)
{
    return coefficients.x + x * (2.0 * coefficients.y + coefficients.z * x);
}

// The squared radius of the core, as a quadratic function of x.
vec3 ew_torus_core2(ew_torus_ray ray, ew_torus_side side, vec4 glow)
{
#ifdef EW_CORE_PIXELS
    float growth = ew_frame.core_floor.x;
    float depth = ew_view_depth.x + ray.center * ew_view_depth.y;
    float depth_slope = side.depth_slope * ew_view_depth.y;
    return vec3(ew_core2(glow, ray.center), growth * depth * depth_slope, growth * depth_slope * depth_slope);
#else
    return vec3(glow.x * glow.x, 0.0, 0.0);
#endif
}

// Where the squared distance is level2 on both sides of `nearest`: by Newton's method, and bisection where that would leave the
// bracket. It starts from the nearer of the edges that a parabola has and `guess`, which holds where the ray runs along the torus. An
// error counts by its square. Where even `nearest` is beyond, side.end twice.
vec2 ew_torus_edges(ew_torus_part part, vec3 level2, float guess)
{
    ew_torus_side side = part.side;
    vec2 away = vec2(-1.0, 1.0);
    vec2 room = vec2(part.nearest - side.begin, side.end - part.nearest);
    float excess = max(ew_quadratic(level2, part.nearest) - part.distance2, 0.0);
    float root = sqrt(part.slope * part.slope + part.curvature * excess);
    vec2 y = min(vec2(min(excess / max(part.slope + root, 1e-30), guess)), room);
    vec2 inside = vec2(0.0);
    vec2 outside = room;
    int step = 0;
    do {
        vec2 x = part.nearest + away * y;
        vec2 outward = side.outward + side.across2 * x;
        vec2 from_axis = sqrt(max(side.from_axis2 + x * (side.outward + outward), 1e-30));
        vec2 beyond_radius = from_axis - side.radius;
        vec2 height = side.height + side.height_slope * x;
        vec2 beyond = beyond_radius * beyond_radius + height * height
                      - (level2.x + x * (2.0 * level2.y + level2.z * x));
        vec2 slope = 2.0 * away * (beyond_radius * outward / from_axis + height * side.height_slope - level2.y - level2.z * x);
        bvec2 is_outside = greaterThan(beyond, vec2(0.0));
        outside = mix(outside, y, is_outside);
        inside = mix(y, inside, is_outside);
        vec2 next = y - beyond / max(slope, 1e-30);
        bvec2 is_off = not(bvec2(next.x >= inside.x && next.x <= outside.x, next.y >= inside.y && next.y <= outside.y));
        y = clamp(mix(next, 0.5 * (inside + outside), is_off), 0.25 * y, 2.0 * y);
    } while (++step < 6);
    bvec2 is_open = lessThan(vec2(ew_torus_distance_squared(side, side.begin), ew_torus_distance_squared(side, side.end)),
                             vec2(ew_quadratic(level2, side.begin), ew_quadratic(level2, side.end)));
    y = mix(y, room, is_open);
    return excess > 0.0 ? part.nearest + away * y : vec2(side.end);
}
#endif
