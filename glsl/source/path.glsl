// Paths: chains of pieces that shine as one. The field is the sum of the pieces' fields, each by the distance to its nearest point,
// less a point's field at each joint, with the weight there: where the nearest point of one piece is a joint, its neighbour's is too,
// or is nearer, and the joint's point cancels one of the two.

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

// ---- Straight pieces

// The planes through the ends of a straight piece cut a ray in three: to what is before the start the start is nearest, to what is
// beyond the end the end, and in between a point of the line.
struct ew_slab {
    vec3 start;
    vec3 end;
    vec3 axis;
    float size;
    float along;  // of the ray's origin from the start
    float growth; // of it with s
    vec2 t;       // the path's parameter at both ends
};

ew_slab ew_make_slab(ew_segment segment, vec4 start, vec4 end)
{
    vec3 way = end.xyz - start.xyz;
    float size = length(way);
    vec3 axis = way / max(size, 1e-30);
    return ew_slab(start.xyz, end.xyz, axis, size, dot(segment.origin - start.xyz, axis), dot(segment.direction, axis),
                   vec2(start.w, end.w));
}

// The s at which the ray comes to the plane at `place` along the piece, in `chord`. A ray parallel to the planes, which does not run
// along the piece, is before or beyond the plane all the way: it comes to it at the end of the chord, or has come at its start.
float ew_s_at_plane(ew_slab slab, float place, vec2 chord)
{
    float way = place - slab.along;
    bool is_parallel = abs(slab.growth) <= 1e-20 * abs(way);
    return is_parallel ? (way > 0.0 ? chord.x : chord.y) : clamp(way / slab.growth, chord.x, chord.y);
}

// The line's squared distance along the ray is b2 + k (s - s0)^2. `part` is cut to what is within reach.
void ew_find_line(ew_segment segment, ew_slab slab, vec4 glow, inout vec2 part, out float b2, out float k, out float s0)
{
    vec3 to_line = slab.start - segment.origin;
    to_line -= dot(to_line, slab.axis) * slab.axis;
    vec3 across = segment.direction - slab.growth * slab.axis;
    k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
    s0 = dot(to_line, across) / k;
    b2 = ew_length_squared(to_line - s0 * across);
#ifdef EW_REACH
    if (glow.y > 0.0) {
        vec2 chord = ew_chord_of(b2, k, s0, glow.y, segment.end);
        part = vec2(clamp(part.x, chord.x, chord.y), clamp(part.y, chord.x, chord.y));
    }
#endif
}

// The line's part of a straight piece without weights: what lies between the planes.
float ew_integrate_slab(ew_segment segment, ew_slab slab, vec2 part, vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    ew_evaluation_count += 1;
    return ew_integrate_within_reach(b2, k, s0, part, glow);
}

// Where the ray comes to the planes of a piece, in `chord`; and whether it runs from the start's to the end's.
struct ew_planes {
    float start;
    float end;
    bool is_along;
};

ew_planes ew_find_planes(ew_slab slab, vec2 chord)
{
    return ew_planes(ew_s_at_plane(slab, 0.0, chord), ew_s_at_plane(slab, slab.size, chord), slab.growth > 0.0);
}

#ifdef EW_WEIGHTS
// Gauss's four nodes on [0, 1].
const vec4 EW_PATH_NODES = vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
const vec4 EW_PATH_NODE_WEIGHTS = vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);

#ifndef EW_WORLD
// More panels than any part takes: they grow by factors.
const int EW_MAX_PATH_PANELS = 64;

// The same with the decay, by Gauss's rule in panels that grow from the line's peak outwards, and no faster than the depth: none is
// longer than its distance from what is singular. Relative error 1e-4.
float ew_integrate_weighted_part(ew_segment segment, ew_slab slab, vec2 part, vec3 weight_by_t, vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    float scale = (slab.t.y - slab.t.x) / max(slab.size, 1e-30);
    float core2 = ew_core2(glow, clamp(s0, part.x, part.y));
    float half_core = sqrt(max(core2 - b2, 0.0) / k);
    float half_peak = sqrt(max(b2, core2) / k);
    float center = clamp(s0, part.x, part.y);
    float sum = 0.0;
    float side = -1.0;
    float from = center;
    int panel = 0;
    do {
        float stop = side < 0.0 ? part.x : part.y;
        float away = abs(from - s0);
        // A panel up to the core's edge may end before it, by rounding. The next one then goes on beyond.
        float size = away < 0.999 * half_core ? half_core - away : max(away, half_peak);
        size = min(size, 0.5 * (from + ew_beta()));
        float to = side < 0.0 ? max(from - size, stop) : min(from + size, stop);
        vec4 s = from + (to - from) * EW_PATH_NODES;
        vec4 t = slab.t.x + scale * (slab.along + s * slab.growth);
        vec4 weight = weight_by_t.x + t * (weight_by_t.y + t * weight_by_t.z);
        vec4 squared = b2 + k * (s - s0) * (s - s0);
        squared = max(squared, vec4(ew_core2(glow, s.x), ew_core2(glow, s.y), ew_core2(glow, s.z), ew_core2(glow, s.w)));
        vec4 depth = s + ew_beta();
        vec4 value = weight * (inversesqrt(squared) - ew_inverse_reach(glow)) / (depth * depth);
        sum += abs(to - from) * dot(EW_PATH_NODE_WEIGHTS, value);
        bool is_side_done = to == stop;
        from = is_side_done ? center : to;
        side = is_side_done ? side + 2.0 : side;
    } while (side < 2.0 && ++panel < EW_MAX_PATH_PANELS);
    ew_evaluation_count += 4;
    return sum;
}
#else
// The integral over [from, to], outside of the core, of (polynomial in y = s - s0) / sqrt(b2 + k y^2): closed forms.
float ew_integrate_weighted_side(float b2, float k, float s0, float from, float to, vec3 polynomial)
{
    float y_from = from - s0;
    float y_to = to - s0;
    float d_from = sqrt(b2 + k * y_from * y_from);
    float d_to = sqrt(b2 + k * y_to * y_to);
    float moment0 = ew_integrate_reciprocal(b2, k, s0, from, to);
    float moment1 = (to - from) * (y_from + y_to) / max(d_from + d_to, 1e-30);
    float moment2 = 0.5 * (y_to * d_to - y_from * d_from - b2 * moment0) / k;
    return polynomial.x * moment0 + polynomial.y * moment1 + polynomial.z * moment2;
}

// The same as ew_integrate_slab for a part of the piece on which the weight is one polynomial of the place along it.
float ew_integrate_weighted_part(ew_segment segment, ew_slab slab, vec2 part, vec3 weight_by_t, vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    float scale = (slab.t.y - slab.t.x) / max(slab.size, 1e-30);
    // Far from the peak, compared with the part's length, all is smooth; and so it is if the peak is much longer than the part, where
    // the moments below would be small differences.
    float half_part = 0.5 * (part.y - part.x);
    bool is_far = abs(0.5 * (part.x + part.y) - s0) > 5.0 * half_part;
    if (is_far || k * half_part * half_part < 0.1 * max(b2, ew_core2(glow, part.x))) {
        vec4 place = part.x + 2.0 * half_part * EW_PATH_NODES;
        vec4 t = slab.t.x + scale * (slab.along + place * slab.growth);
        vec4 value = weight_by_t.x + t * (weight_by_t.y + t * weight_by_t.z);
        vec4 squared = b2 + k * (place - s0) * (place - s0);
        squared = max(squared, vec4(ew_core2(glow, place.x), ew_core2(glow, place.y), ew_core2(glow, place.z), ew_core2(glow, place.w)));
        return 2.0 * half_part * dot(EW_PATH_NODE_WEIGHTS, value * (inversesqrt(squared) - ew_inverse_reach(glow)));
    }
    // The weight by y = s - s0: f = base + slope y is the place in the weight's piece.
    float base = slab.t.x + scale * (slab.along + s0 * slab.growth);
    float slope = scale * slab.growth;
    vec3 polynomial = vec3(weight_by_t.x + base * (weight_by_t.y + base * weight_by_t.z),
                           slope * (weight_by_t.y + 2.0 * base * weight_by_t.z), slope * slope * weight_by_t.z);
    // The core, in which the weight over its radius is smooth.
    float core2 = ew_core2(glow, clamp(s0, part.x, part.y));
    float half_core = sqrt(max(core2 - b2, 0.0) / k);
    vec2 core = vec2(clamp(s0 - half_core, part.x, part.y), clamp(s0 + half_core, part.x, part.y));
    vec4 s = core.x + (core.y - core.x) * EW_PATH_NODES;
    vec4 y = s - s0;
    vec4 weight = polynomial.x + y * (polynomial.y + y * polynomial.z);
    vec4 radius2 = vec4(ew_core2(glow, s.x), ew_core2(glow, s.y), ew_core2(glow, s.z), ew_core2(glow, s.w));
    float sum = (core.y - core.x) * dot(EW_PATH_NODE_WEIGHTS, weight * inversesqrt(radius2));
    if (part.x < core.x) sum += ew_integrate_weighted_side(b2, k, s0, part.x, core.x, polynomial);
    if (core.y < part.y) sum += ew_integrate_weighted_side(b2, k, s0, core.y, part.y, polynomial);
    vec2 ends = part - s0;
    float moment1 = 0.5 * (ends.y - ends.x) * (ends.y + ends.x);
    float moment2 = (ends.y * ends.y * ends.y - ends.x * ends.x * ends.x) / 3.0;
    sum -= ew_inverse_reach(glow) * (polynomial.x * (ends.y - ends.x) + polynomial.y * moment1 + polynomial.z * moment2);
    ew_evaluation_count += 1;
    return sum;
}
#endif

// The most knots of the weights that lie on one straight piece, and one.
const int EW_MAX_PIECE_KNOTS = 1024;

float ew_integrate_weighted_slab(ew_segment segment, ew_slab slab, ew_path_block path, vec2 part)
{
    float count = path.weights.y;
    float piece = min(floor(slab.t.x * count), count - 1.0);
    float last_piece = min(floor(slab.t.y * count), count - 1.0);
    float sum = 0.0;
    int knot = 0;
    do {
        // Between two knots, by the place along the whole path: f = t count - piece.
        vec3 by_f = ew_weight_piece(int(path.weights.x + piece)).polynomial.xyz;
        vec3 by_t = vec3(by_f.x - piece * (by_f.y - piece * by_f.z), count * (by_f.y - 2.0 * piece * by_f.z), count * count * by_f.z);
        vec2 t = clamp(vec2(piece, piece + 1.0) / count, slab.t.x, slab.t.y);
        vec2 place = (t - slab.t.x) / max(slab.t.y - slab.t.x, 1e-30) * slab.size;
        float from = ew_s_at_plane(slab, place.x, part);
        float to = ew_s_at_plane(slab, place.y, part);
        vec2 between = vec2(min(from, to), max(from, to));
        if (between.x < between.y) sum += ew_integrate_weighted_part(segment, slab, between, by_t, path.glow);
        piece += 1.0;
    } while (piece <= last_piece && ++knot < EW_MAX_PIECE_KNOTS);
    return sum;
}
#endif

// The most pieces of a path, as in the public header.
const int EW_MAX_PATH_PIECES = 600;

float ew_integrate_line_of_piece(ew_segment segment, ew_slab slab, ew_path_block path, ew_planes planes)
{
    vec2 between = planes.is_along ? vec2(planes.start, planes.end) : vec2(planes.end, planes.start);
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) return ew_integrate_weighted_slab(segment, slab, path, between);
#endif
    return ew_integrate_slab(segment, slab, between, path.glow);
}

// ---- Straight beams

// A straight beam as a ray meets it. To what is before the plane through the end that the ray comes to first, that end is nearest; to
// what is beyond the other plane, the last end; in between, a point of the line. The squared distance from each along the ray is
// b2 + k (s - s0)^2.
struct ew_beam {
    vec3 b2; // of the first end, the line and the last end
    vec3 k;
    vec3 s0;
    vec2 planes;    // s, in the chord
    bool is_turned; // the path's end is the first
};

// What lies across the ray is found for the middle and for the axis, and from these for both ends.
ew_beam ew_meet_beam(ew_segment segment, ew_path_block path, vec2 chord)
{
    float size = path.ball.w;
    vec3 axis = path.beam.xyz / max(size, 1e-30);
    float growth = dot(segment.direction, axis);
    bool is_turned = growth < 0.0;
    axis *= is_turned ? -1.0 : 1.0;
    growth = abs(growth);
    vec3 to_middle = path.ball.xyz - segment.origin;
    float along = dot(to_middle, axis);
    // A ray parallel to the planes is before or beyond each all the way.
    vec2 planes = clamp((along + vec2(-size, size)) / max(growth, 1e-30), chord.x, chord.y);

    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_middle, segment.direction) / k;
    float step = growth / k;
    vec3 middle_across = to_middle - s0 * segment.direction;
    vec3 end_across = size * (axis - step * segment.direction);
    vec3 to_line = to_middle - along * axis;
    vec3 across = segment.direction - growth * axis;
    float line_k = max(ew_length_squared(across), 1e-12 * k);
    float line_s0 = dot(to_line, across) / line_k;
    return ew_beam(vec3(ew_length_squared(middle_across - end_across), ew_length_squared(to_line - line_s0 * across),
                        ew_length_squared(middle_across + end_across)),
                   vec3(k, line_k, k), vec3(s0 - size * step, line_s0, s0 + size * step), planes, is_turned);
}

#ifdef EW_WORLD
// Both ends of a beam at once, by the form of ew_integrate_node: of each, from the edge of its cap to the end of what the ray has of
// its reach.
vec2 ew_integrate_beam_ends(ew_beam beam, vec2 chord, vec4 glow)
{
    float k = beam.k.x;
    float root_k = sqrt(k);
    vec2 s0 = beam.s0.xz;
    vec2 b2 = beam.b2.xz;
    vec2 b = sqrt(b2);
    vec2 half_chord = sqrt(max((glow.y - b) * (glow.y + b), 0.0) / k);
    vec4 y = clamp(vec4(chord.x, beam.planes, chord.y) - s0.xxyy, -half_chord.xxyy, half_chord.xxyy);
    vec2 core2 = vec2(ew_core2(glow, max(s0.x, 0.0)), ew_core2(glow, max(s0.y, 0.0)));
    vec2 half_core = sqrt(max(core2 - b2, 0.0) / k);
    vec4 outside = max(abs(y), half_core.xxyy);
    vec4 power = sqrt(b2.xxyy + k * outside * outside) + root_k * outside;
    vec2 at_core = sqrt(max(core2, b2)) + root_k * half_core;
    power /= at_core.xxyy;
    // The antiderivative is odd in y.
    vec4 odd = mix(power, 1.0 / power, lessThan(y, vec4(0.0)));
    vec4 inside = clamp(y, -half_core.xxyy, half_core.xxyy);
    vec2 sides = (0.69314718 / root_k) * log2(vec2(odd.y / odd.x, odd.w / odd.z));
    ew_evaluation_count += 2;
    return sides + vec2(inside.y - inside.x, inside.w - inside.z) * inversesqrt(core2) -
           vec2(y.y - y.x, y.w - y.z) * ew_inverse_reach(glow);
}

// `weights` are those of the first end, the line and the last end.
float ew_integrate_beam_parts(ew_beam beam, vec2 chord, vec3 weights, vec4 glow)
{
    vec2 ends = ew_integrate_beam_ends(beam, chord, glow);
    ew_evaluation_count += 1;
    return dot(weights.xz, ends) +
           weights.y * ew_integrate_within_reach(beam.b2.y, beam.k.y, beam.s0.y, beam.planes, glow);
}
#else
// The light of the core in one of a beam's parts.
float ew_integrate_core(vec2 core, vec4 glow)
{
#ifdef EW_CORE_PIXELS
    return ew_integrate_reciprocal(ew_core_radius2(glow), max(ew_core_growth2(), 1e-30), -ew_view_depth.x / ew_view_depth.y, core.x,
                                   core.y);
#else
    return ew_measure(core.x, core.y) / glow.x;
#endif
}

// Along the ray a beam's distance falls up to the core, or to its least, and then grows. So of the three parts' six sides of the core
// two are always empty, but for rounding: behind the core in the first part, or before it in the second; and the same mirrored.
float ew_integrate_beam_parts(ew_beam beam, vec2 chord, vec3 weights, vec4 glow)
{
    vec3 from = vec3(chord.x, beam.planes);
    vec3 to = vec3(beam.planes, chord.y);
#ifdef EW_REACH
    if (glow.y > 0.0) {
        vec3 b = sqrt(beam.b2);
        vec3 half_chord = sqrt(max((glow.y - b) * (glow.y + b), 0.0) / beam.k);
        from = clamp(from, beam.s0 - half_chord, beam.s0 + half_chord);
        to = clamp(to, beam.s0 - half_chord, beam.s0 + half_chord);
    }
#endif
#ifdef EW_CORE_PIXELS
    vec2 first = ew_find_core(beam.b2.x, beam.k.x, beam.s0.x, glow);
    vec2 line = ew_find_core(beam.b2.y, beam.k.y, beam.s0.y, glow);
    vec2 last = ew_find_core(beam.b2.z, beam.k.z, beam.s0.z, glow);
    vec3 core_from = clamp(beam.s0 + vec3(first.x, line.x, last.x), from, to);
    vec3 core_to = clamp(beam.s0 + vec3(first.y, line.y, last.y), from, to);
#else
    vec3 half_core = sqrt(max(glow.x * glow.x - beam.b2, 0.0) / beam.k);
    vec3 core_from = clamp(beam.s0 - half_core, from, to);
    vec3 core_to = clamp(beam.s0 + half_core, from, to);
#endif
    bool is_first = to.x - core_to.x > core_from.y - from.y;
    bool is_last = core_from.z - from.z > to.y - core_to.y;
    vec4 side_from = vec4(from.x, is_first ? core_to.x : from.y, is_last ? from.z : core_to.y, core_to.z);
    vec4 side_to = vec4(core_from.x, is_first ? to.x : core_from.y, is_last ? core_from.z : to.y, to.z);
    vec4 b2 = vec4(beam.b2.x, is_first ? beam.b2.x : beam.b2.y, is_last ? beam.b2.z : beam.b2.y, beam.b2.z);
    vec2 s0 = vec2(is_first ? beam.s0.x : beam.s0.y, is_last ? beam.s0.z : beam.s0.y);
    vec2 k = vec2(is_first ? beam.k.x : beam.k.y, is_last ? beam.k.z : beam.k.y);
    vec4 weight = vec4(weights.x, is_first ? weights.x : weights.y, is_last ? weights.z : weights.y, weights.z);
    ew_evaluation_count += 3;
    float sum = weight.x * ew_integrate_reciprocal(b2.x, beam.k.x, beam.s0.x, side_from.x, side_to.x);
    sum += weight.y * ew_integrate_reciprocal(b2.y, k.x, s0.x, side_from.y, side_to.y);
    sum += weight.z * ew_integrate_reciprocal(b2.z, k.y, s0.y, side_from.z, side_to.z);
    sum += weight.w * ew_integrate_reciprocal(b2.w, beam.k.z, beam.s0.z, side_from.w, side_to.w);
    sum += weights.x * ew_integrate_core(vec2(core_from.x, core_to.x), glow);
    sum += weights.y * ew_integrate_core(vec2(core_from.y, core_to.y), glow);
    sum += weights.z * ew_integrate_core(vec2(core_from.z, core_to.z), glow);
#ifdef EW_REACH
    sum -= ew_inverse_reach(glow) * (weights.x * ew_measure(from.x, to.x) + weights.y * ew_measure(from.y, to.y) +
                                     weights.z * ew_measure(from.z, to.z));
#endif
    return sum;
}
#endif

float ew_integrate_beam(ew_segment segment, ew_path_block path, vec2 chord)
{
    ew_beam beam = ew_meet_beam(segment, path, chord);
    float sum = 0.0;
    vec3 weights = vec3(1.0);
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) {
        vec2 ends = vec2(ew_path_weight(path, 0.0), ew_path_weight(path, 1.0));
        weights = beam.is_turned ? vec3(ends.y, 0.0, ends.x) : vec3(ends.x, 0.0, ends.y);
        vec3 half_way = path.beam.xyz;
        ew_slab slab = ew_make_slab(segment, vec4(path.ball.xyz - half_way, 0.0), vec4(path.ball.xyz + half_way, 1.0));
        sum = ew_integrate_weighted_slab(segment, slab, path, beam.planes);
    }
#endif
    return sum + ew_integrate_beam_parts(beam, chord, weights, path.glow);
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

float ew_integrate_polyline(ew_segment segment, ew_path_block path, vec2 chord)
{
    int count = int(path.pieces.y);
    bool is_closed = path.pieces.w > 0.0;
    int before = is_closed ? count - 1 : 0;
    ew_slab slab = ew_make_slab(segment, ew_piece_unit(path, 2.0, before, 0), ew_piece_unit(path, 2.0, before, 1));
    ew_planes planes = ew_find_planes(slab, chord);
    float end = planes.end;
    bool is_end_ahead = planes.is_along;
    float sum = 0.0;
    int i = 0;
    do {
        slab = ew_make_slab(segment, ew_piece_unit(path, 2.0, i, 0), ew_piece_unit(path, 2.0, i, 1));
        planes = ew_find_planes(slab, chord);
        sum += ew_integrate_line_of_piece(segment, slab, path, planes);
        // What is before the start is ahead on the ray if the ray runs against the piece.
        ew_node node = ew_make_joint(end, is_end_ahead, planes.start, !planes.is_along, chord);
        if (i == 0 && !is_closed) node = ew_make_end(planes.start, !planes.is_along, chord);
        sum += ew_path_weight(path, slab.t.x) * ew_integrate_node(segment, slab.start, node, path.glow);
        end = planes.end;
        is_end_ahead = planes.is_along;
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    if (!is_closed)
        sum += ew_path_weight(path, slab.t.y) *
               ew_integrate_node(segment, slab.end, ew_make_end(end, is_end_ahead, chord), path.glow);
    return sum;
}
#endif

#ifdef EW_BENDS
// ---- Bent pieces

// The sum over the pieces, each with both of its ends, less a whole point for each joint.
float ew_integrate_bends(ew_segment segment, ew_path_block path, vec2 chord, float others)
{
    int count = int(path.pieces.y);
    float sum = 0.0;
    int i = 0;
    do {
        vec4 origin = ew_piece_unit(path, 5.0, i, 0);
        vec4 axis_x = ew_piece_unit(path, 5.0, i, 1);
        vec4 axis_y = ew_piece_unit(path, 5.0, i, 2);
        vec4 axis_z = ew_piece_unit(path, 5.0, i, 3);
        vec4 domain = ew_piece_unit(path, 5.0, i, 4);
        ew_curve_block curve = ew_curve_block(vec4(origin.xyz, path.weights.z), axis_x, axis_y, axis_z,
                                              vec4(domain.xy, path.weights.xy), path.color, path.glow);
        ew_arc arc = ew_make_arc(segment, curve);
#ifdef EW_WEIGHTS
        arc.place = domain.z;
        arc.place_slope = domain.w - domain.z;
#endif
        vec2 part = chord;
#ifdef EW_REACH
        if (path.glow.y > 0.0) part = ew_chord(segment, curve);
#endif
        if (part.x < part.y) sum += ew_integrate_arc(arc, part, others + max(sum, 0.0));
        if (i > 0 || path.pieces.w > 0.0) {
            vec3 joint = origin.xyz + arc.slope_x * arc.first * axis_x.xyz
                         + (arc.slope_y + arc.bend * arc.first) * arc.first * axis_y.xyz;
            sum -= ew_path_weight(path, domain.z) * ew_integrate_point_over(segment, joint, chord, path.glow);
        }
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    return sum;
}
#endif

// The integral over a segment, with the field of a path. It may be less than 0 by rounding, or between the arms of a sharp corner; the
// sum over the sources cuts that.
float ew_integrate(ew_segment segment, ew_path_block path, vec2 chord, float others)
{
    float sum = 0.0;
#ifdef EW_JOINTS
    if (path.pieces.y == 0.0) sum = ew_integrate_beam(segment, path, chord);
    else if (path.pieces.z == 0.0) sum = ew_integrate_polyline(segment, path, chord);
#ifdef EW_BENDS
    else sum = ew_integrate_bends(segment, path, chord, others);
#endif
#else
    sum = ew_integrate_beam(segment, path, chord);
#endif
    return sum;
}
