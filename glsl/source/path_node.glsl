// The points that count in a path: its ends and joints.

// The integral of a point at `position` over a part of the ray that is in its reach.
float ew_integrate_point_over(const ew_segment segment, const vec3 position, vec2 part, const vec4 glow)
{
    vec3 to_point = position - segment.origin;
    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_point, segment.direction) / k;
    float b2 = ew_length_squared(to_point - s0 * segment.direction);
#ifdef EW_REACH
    if (ew_has_reach(glow)) {
        vec2 chord = ew_chord_of(b2, k, s0, glow.y, segment.end);
        part = vec2(clamp(part.x, chord.x, chord.y), clamp(part.y, chord.x, chord.y));
    }
#endif
    float sum = 0.0;
    if (EW_IS_NEEDED(part.x != part.y)) {
        float sign = mix(-1.0, 1.0, part.x < part.y);
        sum = sign * ew_integrate_by_rule(b2, k, s0, vec2(min(part.x, part.y), max(part.x, part.y)), glow);
    }
    return sum;
}

#ifdef EW_WORLD
// A point beside a ray. Its squared distance along the ray is b2 + k y^2, y = s - s0; it is within reach up to `half_chord`,
// and in the core up to `half_core`. There the field is (1 - tilt (s - max(s0, 0))) / core, to the first order, as the core
// grows with depth.
struct ew_point_ray {
    float b2;
    float k;
    float s0;
    float half_chord;
    float core2;
    float half_core;
    float tilt;
    bool is_short; // just within reach
};

ew_point_ray ew_make_point_ray(const ew_segment segment, const vec3 position, const vec4 glow)
{
    vec3 to_point = position - segment.origin;
    ew_point_ray ray;
    ray.k = ew_length_squared(segment.direction);
    ray.s0 = dot(to_point, segment.direction) / ray.k;
    ray.b2 = ew_length_squared(to_point - ray.s0 * segment.direction);
    float b = sqrt(ray.b2);
    ray.half_chord = sqrt(max((glow.y - b) * (glow.y + b), 0.0) / ray.k);
    ray.core2 = ew_core2(glow, max(ray.s0, 0.0));
    ray.half_core = sqrt(max(ray.core2 - ray.b2, 0.0) / ray.k);
    ray.tilt = ew_core_tilt(glow, max(ray.s0, 0.0));
    ray.is_short = ray.k * ew_square(ray.half_chord - ray.half_core) < 0.1 * ew_square(glow.y + sqrt(max(ray.core2, ray.b2)));
    return ray;
}

// The integrals of the point's field from `from` to `to`, counted from s0 and within reach, are the sum of the second component
// and of the logarithm of the first over sqrt(k). Nothing is left of ways from a place to itself. The antiderivative of 1 /
// distance from the core on is
//
//     sign(y) log((d + sqrt(k) |y|) / (d_core + sqrt(k) half_core)) / sqrt(k)
//     = 2 sign(y) atanh(sqrt(k) q) / sqrt(k),        q = (|y| - half_core) / (d + d_core).
//
// Of all ways the logarithms are one of a product. Where the ray passes just within reach, they would be small differences.
vec2 ew_light_of_ways(const ew_point_ray ray, const vec2 to, const vec2 from, const vec4 glow)
{
    float root_k = sqrt(ray.k);
    float d_core = sqrt(max(ray.core2, ray.b2));
    vec4 y = vec4(to, from);
    vec4 outside = max(abs(y), ray.half_core);
    vec4 distance = sqrt(ray.b2 + ray.k * outside * outside);
    vec4 inside = clamp(y, -ray.half_core, ray.half_core);
    float at_point = 1.0 + ray.tilt * max(-ray.s0, 0.0);
    vec4 linear = inside * (at_point - 0.5 * ray.tilt * inside) * inversesqrt(ray.core2) - y * ew_inverse_reach(glow);

    vec4 sum = distance + root_k * outside;
    vec4 at_core = vec4(d_core + root_k * ray.half_core);
    bvec4 is_after = greaterThan(y, vec4(0.0));
    vec4 above = mix(at_core, sum, is_after);
    vec4 below = mix(sum, at_core, is_after);
    vec2 power = (above.xy * below.zw) / (below.xy * above.zw);

    vec4 q = sign(y) * (outside - ray.half_core) / (distance + d_core);
    vec4 x2 = ray.k * q * q;
    vec4 short_way = q * (2.0 + x2 * (0.66666667 + x2 * (0.4 + x2 * (0.28571429 + x2 * (0.22222222 + x2 * 0.18181818)))));
    linear += mix(vec4(0.0), short_way, bvec4(ray.is_short));
    vec2 difference = linear.xy - linear.zw;
    return vec2(mix(power.x * power.y, 1.0, ray.is_short), difference.x + difference.y);
}
#endif

#if defined(EW_WORLD) && defined(EW_FOG) && defined(EW_POLYLINES)
// What an antiderivative with these values at the ends of both ways, `to` and then `from`, gives in all.
float ew_over_ways(const vec4 at_ends)
{
    vec2 difference = at_ends.xy - at_ends.zw;
    return difference.x + difference.y;
}

// The moments of the point's field about `place`, counted from s0, over the same ways: see ew_moments_of_part. Far away the field is
// smooth, and Gauss's rule of two nodes serves.
vec4 ew_moments_of_ways(const ew_point_ray ray, vec2 to, vec2 from, const float place, const vec4 glow)
{
    vec2 center = 0.5 * (to + from);
    vec2 half_way = 0.5 * (to - from);
    vec4 node = center.xxyy + half_way.xxyy * vec4(-0.57735027, 0.57735027, -0.57735027, 0.57735027);
    vec4 node_distance2 = ray.b2 + ray.k * node * node;
    vec4 at_core = (1.0 + ray.tilt * (max(-ray.s0, 0.0) - node)) * inversesqrt(ray.core2);
    vec4 field = mix(inversesqrt(max(node_distance2, ray.core2)), at_core, lessThan(node_distance2, vec4(ray.core2)));
    field = (field - ew_inverse_reach(glow)) * half_way.xxyy;
    bvec2 is_far = greaterThan(ray.b2 + ray.k * center * center, EW_CUBIC_FAR * EW_CUBIC_FAR * ray.k * half_way * half_way);
    field = mix(vec4(0.0), field, is_far.xxyy);
    node -= place;
    vec4 far_moments = vec4(dot(field, vec4(1.0)), dot(field, node), dot(field, node * node), dot(field, node * node * node));
    to = mix(to, vec2(0.0), is_far);
    from = mix(from, vec2(0.0), is_far);

    vec2 light = ew_light_of_ways(ray, to, from, glow);
    vec4 y = vec4(to, from);
    vec4 side = mix(vec4(1.0), vec4(-1.0), lessThan(y, vec4(0.0)));
    vec4 outside = side * max(abs(y), ray.half_core);
    vec4 inside = clamp(y, -ray.half_core, ray.half_core);
    vec4 distance = sqrt(ray.b2 + ray.k * outside * outside);
    float d_core = sqrt(max(ray.core2, ray.b2));
    float inverse_core = inversesqrt(ray.core2);
    float at_point = 1.0 + ray.tilt * max(-ray.s0, 0.0);
    vec4 in_core = inside * inverse_core;
    vec4 square = outside * outside;

    vec4 moments;
    moments.x = 0.69314718 * log2(light.x) * inversesqrt(ray.k) + light.y;
    float of_core = ew_over_ways(in_core * (at_point - 0.5 * ray.tilt * inside));
    float of_reach = ew_inverse_reach(glow) * ew_over_ways(y);
    float of_distance = moments.x - of_core + of_reach;
    // Differences of distances, as quotients.
    vec2 first = (outside.xy - outside.zw) * (outside.xy + outside.zw) / max(distance.xy + distance.zw, 1e-30);
    moments.y = first.x + first.y;
    moments.z = (ew_over_ways(outside * distance - side * (ray.half_core * d_core)) - ray.b2 * of_distance) * 0.5 / ray.k;
    moments.w = (ew_over_ways(square * distance) - 2.0 * ray.b2 * moments.y) * (1.0 / 3.0) / ray.k;
    vec4 inner = inside * in_core;
    moments.y += ew_over_ways(inner * (0.5 * at_point - (1.0 / 3.0) * ray.tilt * inside) - 0.5 * ew_inverse_reach(glow) * y * y);
    inner *= inside;
    moments.z += ew_over_ways((1.0 / 3.0) * inner - (1.0 / 3.0) * ew_inverse_reach(glow) * y * y * y);
    moments.w += ew_over_ways(0.25 * inner * inside - 0.25 * ew_inverse_reach(glow) * y * y * y * y);
    return far_moments + ew_shift_moments(moments, place);
}
#endif

#ifdef EW_POLYLINES
// Where a point counts: on the ways along the ray from `from` to `to`, which count negatively where they go backwards.
struct ew_node {
    vec2 to;
    vec2 from;
};

// A free end: the cap that begins or ends at `edge`. It lies towards the ray's end if `is_ahead`.
ew_node ew_make_end(const float edge, const bool is_ahead, const vec2 chord)
{
    return ew_node(vec2(mix(edge, chord.y, is_ahead), edge), vec2(mix(chord.x, edge, is_ahead), edge));
}

// A joint: the cap beyond the piece before it and the cap before the piece behind it, less the point itself. Where one cap
// begins at the ray's start and the other ends at its end, all but the way between their edges cancels.
ew_node ew_make_joint(const float beyond, const bool is_beyond_ahead, const float before, const bool is_before_ahead,
                      const vec2 chord)
{
    // Caps on different sides leave what is between their edges.
    bvec2 is_ahead = bvec2(is_beyond_ahead);
    vec2 way = mix(vec2(beyond, before), vec2(before, beyond), is_ahead);
    vec2 edges = vec2(max(beyond, before), min(beyond, before));
    bvec2 is_split = bvec2(is_beyond_ahead != is_before_ahead);
    return ew_node(mix(mix(edges, chord.yx, is_ahead), way.xx, is_split), mix(mix(chord.yx, edges, is_ahead), way.yx, is_split));
}

#if defined(EW_WORLD) && !defined(EW_FOG)
float ew_integrate_node(const ew_segment segment, const vec3 position, const ew_node node, const vec4 glow)
{
    ew_point_ray ray = ew_make_point_ray(segment, position, glow);
    vec4 y = clamp(vec4(node.to, node.from) - ray.s0, -ray.half_chord, ray.half_chord);
    vec2 light = ew_light_of_ways(ray, y.xy, y.zw, glow);
    ew_evaluation_count += 1;
    return 0.69314718 * log2(light.x) * inversesqrt(ray.k) + light.y;
}
#elif !defined(EW_WORLD)
float ew_integrate_node(const ew_segment segment, const vec3 position, const ew_node node, const vec4 glow)
{
    float sum = 0.0;
    for (int i = 0; i < 2; ++i) {
        vec2 way = mix(vec2(node.from.x, node.to.x), vec2(node.from.y, node.to.y), bvec2(i == 1));
        sum += ew_integrate_point_over(segment, position, way, glow);
    }
    return sum;
}
#endif
#endif

#ifdef EW_BENDS
// The light of a point over the part `last` of the ray, to which it is nearest as the end of one piece, with that piece's
// weight, and over `first`, to which it is nearest as the start of the next; less a whole point, over `whole`. A free end has
// but one of the parts.
float ew_integrate_meeting(const ew_segment segment, const vec3 position, const vec2 last, const vec2 first, const vec2 whole,
                           const vec2 weights, const vec4 glow)
{
#if defined(EW_WORLD) && !defined(EW_FOG)
    ew_point_ray ray = ew_make_point_ray(segment, position, glow);
    vec4 parts = clamp(vec4(last, first) - ray.s0, -ray.half_chord, ray.half_chord);
    vec2 all = clamp(whole - ray.s0, -ray.half_chord, ray.half_chord);
    vec2 outer = ew_light_of_ways(ray, vec2(max(parts.y, parts.w), all.x), vec2(all.y, min(parts.x, parts.z)), glow);
    vec2 inner = ew_light_of_ways(ray, vec2(min(parts.y, parts.w), 0.0), vec2(max(parts.x, parts.z), 0.0), glow);
    float sum = weights.y * (0.69314718 * log2(outer.x * inner.x) * inversesqrt(ray.k) + outer.y + inner.y);
    ew_evaluation_count += 1;
    if (weights.x != weights.y) sum += (weights.x - weights.y) * ew_integrate_point_over(segment, position, last, glow);
    return sum;
#elif defined(EW_FOG)
    // The same ways, so that nothing is left of those from a place to itself; of two that cancel, fog would leave a rest.
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 way = mix(last, vec2(whole.y, max(last.y, first.y)), bvec2(i == 1));
        way = mix(way, vec2(min(last.x, first.x), whole.x), bvec2(i == 2));
        way = mix(way, vec2(max(last.x, first.x), min(last.y, first.y)), bvec2(i == 3));
        float weight = mix(weights.y, weights.x - weights.y, i == 0);
        sum += weight * ew_integrate_point_over(segment, position, way, glow);
    }
    return sum;
#else
    // A loop, because compilers put the point's integral into the shader for every place that calls it.
    float sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        vec2 part = mix(mix(whole, first, bvec2(i == 1)), last, bvec2(i == 0));
        float weight = mix(mix(-weights.y, weights.y, i == 1), weights.x, i == 0);
        sum += weight * ew_integrate_point_over(segment, position, part, glow);
    }
    return sum;
#endif
}
#endif
