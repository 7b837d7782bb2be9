// The points that count in a path: its ends and joints.

// The integral of a point at `position` over a part of the ray that is in its reach.
float ew_integrate_point_over(ew_segment segment, vec3 position, vec2 part, vec4 glow)
{
    vec3 to_point = position - segment.origin;
    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_point, segment.direction) / k;
    float b2 = ew_length_squared(to_point - s0 * segment.direction);
#ifdef EW_REACH
    if (glow.y > 0.0) {
        vec2 chord = ew_chord_of(b2, k, s0, glow.y, segment.end);
        part = vec2(clamp(part.x, chord.x, chord.y), clamp(part.y, chord.x, chord.y));
    }
#endif
    float sum = 0.0;
    if (EW_IS_NEEDED(part.x != part.y)) {
        float sign = part.x < part.y ? 1.0 : -1.0;
        sum = sign * ew_integrate_within_reach(b2, k, s0, vec2(min(part.x, part.y), max(part.x, part.y)), glow);
    }
    return sum;
}

#ifdef EW_JOINTS
// Where a point counts: the sum of `signs` times the antiderivative, along the ray, of its field at `places`. The signs add up to 0.
struct ew_node {
    vec4 places; // the edges of the caps before and behind, and the ends of what the ray has of the point's reach
    vec4 signs;
};

// A free end: the cap that begins or ends at `edge`. It lies towards the ray's end if `is_ahead`.
ew_node ew_make_end(float edge, bool is_ahead, vec2 chord)
{
    return ew_node(vec4(edge, edge, chord), is_ahead ? vec4(-1.0, 0.0, 0.0, 1.0) : vec4(1.0, 0.0, -1.0, 0.0));
}

// A joint: the cap beyond the piece before it and the cap before the piece behind it, less the point itself. Where one cap begins at
// the ray's start and the other ends at its end, all but the way between their edges cancels.
ew_node ew_make_joint(float beyond, bool is_beyond_ahead, float before, bool is_before_ahead, vec2 chord)
{
    vec4 signs = is_beyond_ahead == is_before_ahead ? vec4(-1.0, -1.0, 1.0, 1.0) : vec4(-1.0, 1.0, 0.0, 0.0);
    return ew_node(vec4(beyond, before, chord), is_beyond_ahead ? signs : -signs);
}

#ifdef EW_WORLD
// The antiderivative is sign(y) log((d + sqrt(k) |y|) / (d_core + sqrt(k) h)) / sqrt(k), |y| >= h, with h half of the core; in it,
// y / r'. Logarithms become one of a product.
float ew_integrate_node(ew_segment segment, vec3 position, ew_node node, vec4 glow)
{
    vec3 to_point = position - segment.origin;
    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_point, segment.direction) / k;
    float b2 = ew_length_squared(to_point - s0 * segment.direction);
    float root_k = sqrt(k);
    float half_chord = sqrt(max((glow.y - sqrt(b2)) * (glow.y + sqrt(b2)), 0.0) / k);
    vec4 y = clamp(node.places - s0, -half_chord, half_chord);
    float core2 = ew_core2(glow, max(s0, 0.0));
    float half_core = sqrt(max(core2 - b2, 0.0) / k);
    vec4 outside = max(abs(y), half_core);
    vec4 power = (sqrt(b2 + k * outside * outside) + root_k * outside) / (sqrt(max(core2, b2)) + root_k * half_core);
    vec4 turn = node.signs * sign(y);
    power = mix(mix(vec4(1.0), 1.0 / power, lessThan(turn, vec4(0.0))), power, greaterThan(turn, vec4(0.0)));
    float sides = 0.69314718 * log2(power.x * power.y * power.z * power.w) / root_k;
    ew_evaluation_count += 1;
    return sides + dot(node.signs, clamp(y, -half_core, half_core)) * inversesqrt(core2) -
           dot(node.signs, y) * ew_inverse_reach(glow);
}
#else
float ew_integrate_node(ew_segment segment, vec3 position, ew_node node, vec4 glow)
{
    float start = node.places.z;
    float sum = 0.0;
    int i = 0;
    do {
        float place = i == 0 ? node.places.x : i == 1 ? node.places.y : node.places.w;
        float sign = i == 0 ? node.signs.x : i == 1 ? node.signs.y : node.signs.w;
        if (sign != 0.0) sum += sign * ew_integrate_point_over(segment, position, vec2(start, place), glow);
    } while (++i < 3);
    return sum;
}
#endif
#endif
