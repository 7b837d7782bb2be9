// The parts of a ray beside a torus within reach: on each, the distance falls up to one place and grows from there on.
// docs/method.md, section 11, has the derivation.
#ifdef EW_REACH

// Where the slope has its last zero, beyond which the distance only grows. The slope is a convex function of x. It falls up to
// the place `flat_at`, and is positive from `steep_at` on, as q is at most sqrt(across2). From any place between, Newton's
// method comes down to that zero.
float ew_last_approach_to_torus(const ew_torus_ray ray, const ew_torus_side side)
{
    float pull = side.radius * sqrt(side.across2) - side.outward - side.height * side.height_slope;
    float steep_at = max(pull / ray.direction2, 0.0);
    float flat_from_axis2 = pow(max(side.radius * ray.moment2 / ray.direction2, 1e-30), 0.66666667);
    float flat_at = (sqrt(max(side.across2 * flat_from_axis2 - ray.moment2, 0.0)) - side.outward) / side.across2;
    float x = clamp(ew_nearest_to_torus(ray, side).x, clamp(flat_at, 0.0, steep_at), steep_at);
    int step = 0;
    do {
        vec2 slope = ew_torus_slope(ray, side, x);
        x = clamp(x - slope.x / max(slope.y, 1e-3 * ray.direction2), 0.0, steep_at);
    } while (++step < 3);
    return min(x, side.end);
}

// Where the distance, which grows from the cut on, is largest before it falls to `nearest`. With q as a share of its largest
// value, sqrt(across2), the slope is a convex function of q, too. So from where x would be 0, Newton's method goes up to its
// first zero.
float ew_farthest_from_torus(const ew_torus_ray ray, const ew_torus_side side, const float nearest)
{
    float scale = sqrt(ray.moment2) / side.across2;
    float pull = side.radius * sqrt(side.across2);
    float slope_without = side.outward + side.height * side.height_slope;
    float q = min(slope_without / max(pull, 1e-30), 0.999999);
    float x = 0.0;
    int step = 0;
    do {
        float inverse2 = 1.0 / (1.0 - q * q);
        float inverse = sqrt(inverse2);
        x = scale * q * inverse - side.outward / side.across2;
        float slope = slope_without + ray.direction2 * x - pull * q;
        float growth = ray.direction2 * scale * inverse2 * inverse - pull;
        q = clamp(q - slope / min(growth, -0.05 * pull - 1e-30), q, 0.999999);
    } while (++step < 4);
    return clamp(x, 0.0, nearest);
}

// A part of a side: [side.begin, side.end].
struct ew_torus_part {
    ew_torus_side side;
    float nearest;
    float distance2; // the squared distance at `nearest`, half its derivative and half the second
    float slope;
    float curvature;
};

ew_torus_part ew_make_torus_part(const ew_torus_ray ray, const ew_torus_side side, float nearest)
{
    // Where the slope is nearly 0 over a long way, a few steps may end beyond its zero, and farther away than the part's begin.
    bool is_begin_nearer = ew_torus_distance_squared(side, side.begin) < ew_torus_distance_squared(side, nearest);
    nearest = is_begin_nearer ? side.begin : nearest;
    vec2 slope = ew_torus_slope(ray, side, nearest);
    return ew_torus_part(side, nearest, ew_torus_distance_squared(side, nearest), abs(slope.x), max(slope.y, 0.0));
}

// A squared distance that may grow with view depth: constant + growth (depth + depth_slope x)^2.
struct ew_torus_level {
    float constant;
    float growth;
    float depth;
    float depth_slope;
};

float ew_level_at(const ew_torus_level level, const float x)
{
    return level.constant + level.growth * ew_square(level.depth + level.depth_slope * x);
}

// The squared radius of the core.
ew_torus_level ew_torus_core2(const ew_torus_ray ray, const ew_torus_side side, const vec4 glow)
{
#ifdef EW_CORE_PIXELS
    return ew_torus_level(ew_core_radius2(glow), ew_frame.core_floor.x, ew_view_depth.x + ray.center * ew_view_depth.y,
                          side.depth_slope * ew_view_depth.y);
#else
    return ew_torus_level(glow.x * glow.x, 0.0, 0.0, 0.0);
#endif
}

// Where the squared distance is the level on both sides of `nearest`: by Newton's method, and by bisection where that would
// leave the bracket. It starts from the nearer of the edges that a parabola would have and `guess`, which holds where the ray
// runs along the torus. As steps are bounded by factors, rounding cannot throw an edge far away. An error counts by its square.
// If even `nearest` is beyond, both edges are side.end.
vec2 ew_torus_edges(const ew_torus_part part, const ew_torus_level level, const float guess)
{
    ew_torus_side side = part.side;
    vec2 away = vec2(-1.0, 1.0);
    vec2 room = vec2(part.nearest - side.begin, side.end - part.nearest);
    float excess = max(ew_level_at(level, part.nearest) - part.distance2, 0.0);
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
        vec2 depth = level.depth + level.depth_slope * x;
        vec2 beyond = beyond_radius * beyond_radius + height * height - level.constant - level.growth * depth * depth;
        vec2 slope = 2.0 * away * (beyond_radius * outward / from_axis + height * side.height_slope
                                 - level.growth * level.depth_slope * depth);
        bvec2 is_outside = greaterThan(beyond, vec2(0.0));
        outside = mix(outside, y, is_outside);
        inside = mix(y, inside, is_outside);
        vec2 next = y - beyond / max(slope, 1e-30);
        bvec2 is_off = bvec2(next.x < inside.x || next.x > outside.x, next.y < inside.y || next.y > outside.y);
        y = clamp(mix(next, 0.5 * (inside + outside), is_off), 0.25 * y, 2.0 * y);
    } while (++step < 5);
    vec2 at_ends = vec2(ew_torus_distance_squared(side, side.begin), ew_torus_distance_squared(side, side.end));
    bvec2 is_open = lessThan(at_ends, vec2(ew_level_at(level, side.begin), ew_level_at(level, side.end)));
    y = mix(y, room, is_open);
    return excess > 0.0 ? part.nearest + away * y : vec2(side.end);
}
#endif
