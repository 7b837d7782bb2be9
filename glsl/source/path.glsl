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

// The weight at t along a path.
float ew_path_weight(ew_path_block path, float t)
{
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) return ew_weight(t, path.weights.x, path.weights.y);
#endif
    return 1.0;
}

vec4 ew_piece_unit(ew_path_block path, float units, int i, int unit)
{
    return ew_source_data[int(path.pieces.x) + i * int(units) + unit];
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

ew_slab ew_make_slab(ew_segment segment, ew_path_block path, int i)
{
    vec4 start = ew_piece_unit(path, 2.0, i, 0);
    vec4 end = ew_piece_unit(path, 2.0, i, 1);
    vec3 way = end.xyz - start.xyz;
    float size = length(way);
    vec3 axis = way / max(size, 1e-30);
    return ew_slab(start.xyz, end.xyz, axis, size, dot(segment.origin - start.xyz, axis), dot(segment.direction, axis),
                   vec2(start.w, end.w));
}

// The s at which the ray comes to the plane at `place` along the piece. A ray parallel to the planes is before or beyond them all
// along: then it is far behind or far ahead of all, on the side that says so.
float ew_s_at_plane(ew_slab slab, float place, vec2 chord)
{
    float way = place - slab.along;
    return abs(slab.growth) > 1e-20 * abs(way) ? clamp(way / slab.growth, chord.x, chord.y)
                                               : (way > 0.0 ? chord.y : chord.x);
}

// The line's part of a straight piece without weights: what lies between the planes.
float ew_integrate_slab(ew_segment segment, ew_slab slab, vec2 part, vec4 glow)
{
    vec3 to_line = slab.start - segment.origin;
    to_line -= dot(to_line, slab.axis) * slab.axis;
    vec3 across = segment.direction - slab.growth * slab.axis;
    float k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
    float s0 = dot(to_line, across) / k;
    float b2 = ew_length_squared(to_line - s0 * across);
#ifdef EW_REACH
    if (glow.y > 0.0) {
        vec2 chord = ew_chord_of(b2, k, s0, glow.y, segment.end);
        part = vec2(clamp(part.x, chord.x, chord.y), clamp(part.y, chord.x, chord.y));
    }
#endif
    ew_evaluation_count += 1;
    return ew_integrate_within_reach(b2, k, s0, part, glow);
}

// The parts of the ray before the start and beyond the end of a piece, as half-lines that begin at chord.x or end at chord.y.
struct ew_caps {
    vec2 before;
    vec2 beyond;
    vec2 between;
};

ew_caps ew_find_caps(ew_slab slab, vec2 chord)
{
    float at_start = ew_s_at_plane(slab, 0.0, chord);
    float at_end = ew_s_at_plane(slab, slab.size, chord);
    bool is_along = slab.growth > 0.0;
    bool is_across = abs(slab.growth) <= 1e-20 * max(abs(slab.along), abs(slab.size - slab.along));
    ew_caps caps;
    caps.before = is_along ? vec2(chord.x, at_start) : vec2(at_start, chord.y);
    caps.beyond = is_along ? vec2(at_end, chord.y) : vec2(chord.x, at_end);
    caps.between = is_along ? vec2(at_start, at_end) : vec2(at_end, at_start);
    if (is_across) {
        bool is_before = slab.along < 0.0;
        bool is_beyond = slab.along > slab.size;
        caps.before = is_before ? chord : chord.xx;
        caps.beyond = is_beyond ? chord : chord.xx;
        caps.between = is_before || is_beyond ? chord.xx : chord;
    }
    return caps;
}

// What is left at a joint of the caps of both pieces and the point that is taken away: `beyond` the one, `before` the other. Where one
// of these begins at the chord's start and the other ends at its end, all but the way between their edges cancels.
float ew_integrate_joint(ew_segment segment, vec3 position, vec2 beyond, vec2 before, vec2 chord, vec4 glow)
{
    bool is_opposite = (beyond.x <= chord.x) != (before.x <= chord.x);
    bool has_start = beyond.x <= chord.x;
    float inner = has_start ? beyond.y : beyond.x;
    float other = before.x <= chord.x ? before.y : before.x;
    vec2 first = is_opposite ? (has_start ? vec2(other, inner) : vec2(inner, other)) : vec2(chord.x, min(inner, other));
    vec2 second = vec2(max(inner, other), chord.y);
    float sum = ew_integrate_point_over(segment, position, first, glow);
    if (!is_opposite) {
        sum -= ew_integrate_point_over(segment, position, second, glow);
        sum = has_start ? sum : -sum;
    }
    return sum;
}

#ifdef EW_WEIGHTS
// Gauss's four nodes on [0, 1].
const vec4 EW_PATH_NODES = vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
const vec4 EW_PATH_NODE_WEIGHTS = vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);

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
    vec3 to_line = slab.start - segment.origin;
    to_line -= dot(to_line, slab.axis) * slab.axis;
    vec3 across = segment.direction - slab.growth * slab.axis;
    float k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
    float s0 = dot(to_line, across) / k;
    float b2 = ew_length_squared(to_line - s0 * across);
#ifdef EW_REACH
    if (glow.y > 0.0) {
        vec2 chord = ew_chord_of(b2, k, s0, glow.y, segment.end);
        part = vec2(clamp(part.x, chord.x, chord.y), clamp(part.y, chord.x, chord.y));
    }
#endif
    // The weight by y = s - s0: f = base + slope y is the place in the weight's piece.
    float scale = (slab.t.y - slab.t.x) / max(slab.size, 1e-30);
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

float ew_integrate_polyline(ew_segment segment, ew_path_block path, vec2 chord)
{
    int count = int(path.pieces.y);
    bool is_closed = path.pieces.w > 0.0;
    ew_slab slab = ew_make_slab(segment, path, 0);
    ew_caps caps = ew_find_caps(slab, chord);
    vec3 first_start = slab.start;
    vec2 first_before = caps.before;
    float first_weight = ew_path_weight(path, slab.t.x);
    float sum = is_closed ? 0.0 : first_weight * ew_integrate_point_over(segment, slab.start, caps.before, path.glow);
    int i = 0;
    do {
#ifdef EW_WEIGHTS
        if (path.weights.y > 0.0) sum += ew_integrate_weighted_slab(segment, slab, path, caps.between);
        else sum += ew_integrate_slab(segment, slab, caps.between, path.glow);
#else
        sum += ew_integrate_slab(segment, slab, caps.between, path.glow);
#endif
        vec3 end = slab.end;
        vec2 beyond = caps.beyond;
        bool is_last = i == count - 1;
        float end_weight = ew_path_weight(path, slab.t.y);
        slab = ew_make_slab(segment, path, is_last ? i : i + 1);
        caps = ew_find_caps(slab, chord);
        vec2 before = is_last ? first_before : caps.before;
        float joint_weight = is_last ? first_weight : ew_path_weight(path, slab.t.x);
        if (is_last && !is_closed) sum += end_weight * ew_integrate_point_over(segment, end, beyond, path.glow);
        else sum += joint_weight * ew_integrate_joint(segment, is_last ? first_start : slab.start, beyond, before, chord, path.glow);
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    return sum;
}

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
float ew_integrate(ew_segment segment, ew_path_block path, float others)
{
    vec2 chord = vec2(0.0, segment.end);
#ifdef EW_REACH
    if (path.glow.y > 0.0) chord = ew_chord(segment, path);
#endif
    float sum = 0.0;
    if (chord.x < chord.y) {
#ifdef EW_BENDS
        if (path.pieces.z > 0.0) sum = ew_integrate_bends(segment, path, chord, others);
        else sum = ew_integrate_polyline(segment, path, chord);
#else
        sum = ew_integrate_polyline(segment, path, chord);
#endif
    }
    return sum;
}
