// Straight emitters without weights, in closed form. With t the way along the emitter from the foot of the perpendicular, at
// distance h from the surface, d^2 = h^2 + t^2 and n . (C - P) = a + b t:
//
//     integral of (a + b t) / d (1 / d - d / L^2)^2 dt = sum of integrals of (a + b t) d^k,  k = -3, -1, 1,
//
// outside of the core, and a constant times that of (a + b t) / d in it.

// The integrals of d^k and t d^k from t.x to t.y, outside of the core: there t has one sign unless the whole emitter is outside.
// Differences of squares are written as products, since they would cancel.
float ew_light_outside(const vec2 t, const float h2, const float a, const float b)
{
    vec2 d = sqrt(h2 + t * t);
    float difference = (t.y - t.x) * (t.y + t.x);
    float growth = difference / (d.x + d.y); // of d
    vec2 low = abs(t);
    bool is_one_sided = t.x * t.y > 0.0;
    float cross_sum = t.y * d.x + t.x * d.y;
    float k3 = mix((t.y / d.y - t.x / d.x) / h2, difference / (d.x * d.y * mix(1.0, cross_sum, is_one_sided)), is_one_sided);
    vec2 reach = low + d;
    float arc = mix(log(reach.x * reach.y / h2), abs(log(reach.y / reach.x)), is_one_sided);
    float k1 = 0.5 * (t.y * d.y - t.x * d.x + h2 * arc);
    float cubes = growth * (d.x * d.x + d.x * d.y + d.y * d.y) / 3.0;
    float inverse_reach2 = 1.0 / ew_square(ew_light_reach());
    float even = k3 + inverse_reach2 * (inverse_reach2 * k1 - 2.0 * arc);
    float odd = growth / (d.x * d.y) + inverse_reach2 * (inverse_reach2 * cubes - 2.0 * growth);
    return a * even + b * odd;
}

// The same in the core, but for k(r).
float ew_light_inside(const vec2 t, const float h2, const float a, const float b)
{
    vec2 d = sqrt(h2 + t * t);
    vec2 reach = abs(t) + d;
    float arc = mix(log(reach.x * reach.y / h2), abs(log(reach.y / reach.x)), t.x * t.y > 0.0);
    return a * arc + b * (t.y - t.x) * (t.y + t.x) / (d.x + d.y);
}

// The part of an interval on which a + b t > 0, if there is any.
vec2 ew_above_horizon(const float a, const float b, const vec2 t)
{
    vec2 above = a + b * t;
    float horizon = mix(t.x, t.y, clamp(above.x / mix(above.x - above.y, 1.0, above.x == above.y), 0.0, 1.0));
    return mix(t, vec2(horizon), lessThan(above, vec2(0.0)));
}

// The integral over the emitter from t.x to t.y along the unit vector `axis`; `foot` leads from the surface to t = 0, perpendicular to
// the axis. Relative error some 1e-5 where the emitter is above the surface's horizon, which cuts it.
float ew_light_of_straight(const ew_surface surface, const vec3 foot, const vec3 axis, vec2 t, const float core)
{
    float a = dot(surface.normal, foot);
    float b = dot(surface.normal, axis);
    if (max(a + b * t.x, a + b * t.y) <= 0.0) return 0.0;
    t = ew_above_horizon(a, b, t);
    // Where the surface is next to the emitter's line, what is left out by this is a millionth of the light.
    float core2 = core * core;
    float h2 = max(ew_length_squared(foot), 1e-12 * core2);
    float last2 = ew_square(ew_light_reach()) - h2;
    if (last2 <= 0.0) return 0.0;
    float last = sqrt(last2);
    t = clamp(t, -last, last);
    float edge = sqrt(max(core2 - h2, 0.0));
    vec2 before = vec2(t.x, min(t.y, -edge));
    vec2 behind = vec2(max(t.x, edge), t.y);
    vec2 within = clamp(t, -edge, edge);
    float sum = 0.0;
    if (edge == 0.0) return ew_light_outside(t, h2, a, b);
    if (before.x < before.y) sum += ew_light_outside(before, h2, a, b);
    if (behind.x < behind.y) sum += ew_light_outside(behind, h2, a, b);
    if (within.x < within.y) sum += ew_light_falloff(core2, core) * ew_light_inside(within, h2, a, b);
    return sum;
}

// From `start` to `end`, relative to the surface.
float ew_light_of_segment(const ew_surface surface, const vec3 start, const vec3 end, const float core)
{
    vec3 way = end - start;
    float way_length = length(way);
    vec3 axis = way / max(way_length, 1e-30);
    float first = dot(start, axis);
    return way_length > 0.0 ? ew_light_of_straight(surface, start - first * axis, axis, vec2(first, first + way_length), core) : 0.0;
}

// Where a surface is in the core of a bent emitter, as many straight pieces stand for what is next to it on either side.
const int EW_NEAR_CHORDS = 6;

// A short piece of a bent emitter, as a straight one as far away on the average: a parabola is two thirds of the way from its chord to its
// middle.
float ew_light_of_nearly_straight(const ew_surface surface, const vec3 start, const vec3 middle, const vec3 end, const float core)
{
    vec3 shift = (middle - 0.5 * (start + end)) * (2.0 / 3.0);
    return ew_light_of_segment(surface, start + shift, end + shift, core);
}
