// Paths with bent pieces.

#ifdef EW_BENDS
// The least share of a closed path's light that errors are compared with: rounding is not much less.
const float EW_LEAST_SHARE = 0.01;

vec3 ew_place_at(const ew_curve_block curve, const float tau)
{
    return curve.origin.xyz + ew_slope_x(curve) * tau * curve.axis_x.xyz +
           (ew_slope_y(curve) + ew_bend(curve) * tau) * tau * curve.axis_y.xyz;
}

// The part of `chord` on which the i-th piece may be within reach.
vec2 ew_chord_of_piece(const ew_segment segment, const ew_path_block path, const int i, vec2 chord)
{
#ifdef EW_REACH
    if (ew_has_reach(path.glow)) {
        // The search goes on one beyond the last piece.
        int piece = min(i, int(path.pieces.y) - 1);
        vec4 ball = ew_bent_unit(path, piece, 5);
        vec4 along = ew_bent_unit(path, piece, 6);
        float reach = path.glow.y;
        chord = clamp(ew_capsule_chord(segment, ball.xyz, along.xyz, ball.w + reach, along.w + reach), chord.x, chord.y);
    }
#endif
    return chord;
}

// The first piece from the i-th on that the ray does not miss, and the part of `chord` on which it is within reach; the count of pieces if
// there is none. Like sources (light.glsl), the others are passed over in a loop of their own, which stays where it is once it has found
// one.
int ew_find_piece(const ew_segment segment, const ew_path_block path, int i, const vec2 chord, out vec2 part)
{
    int count = int(path.pieces.y);
    bool is_hit = false;
    do {
        part = ew_chord_of_piece(segment, path, i, chord);
        is_hit = is_hit || part.x < part.y;
        i += is_hit ? 0 : 1;
    } while (!is_hit && i < count && i < EW_MAX_PATH_PIECES);
    return is_hit ? i : count;
}

// The sum over the pieces: each where no end is nearest, and its start together with the end of the piece before. Of a joint
// with a piece that the ray misses, nothing is within reach.
float ew_integrate_bends(const ew_segment segment, const ew_path_block path, const vec2 chord, const float others)
{
    int count = int(path.pieces.y);
    bool is_closed = path.pieces.w > 0.0;
    // A closed path has as many joints as pieces: of its light, seen from beyond its ball, about as much is left as its size is of
    // the distance.
    float size2 = path.ball.w * path.ball.w * ew_length_squared(segment.direction);
    float away2 = max(ew_length_squared(cross(path.ball.xyz - segment.origin, segment.direction)), 1e-30);
    float share = mix(1.0, clamp(sqrt(size2 / away2), EW_LEAST_SHARE, 1.0), is_closed);
    vec2 start = chord.xx; // of a closed path, the part to which its start is nearest
    vec2 last = chord.xx;
    vec3 end = vec3(0.0);
    float last_weight = 1.0;
    float sum = 0.0;
    bool has_start = false; // the ray does not miss the first piece
    int done = 0;
    vec2 part;
    int i = ew_find_piece(segment, path, 0, chord, part);
    // The next piece is looked for before the loop ends, so that a software rasteriser does not go through it for nothing.
    do {
        if (i < count) {
#ifndef EW_SOFTWARE
            // SwiftShader loses what a loop finds that some pixels have left.
            part = ew_chord_of_piece(segment, path, i, chord);
#endif
            vec4 domain = ew_bent_unit(path, i, 4);
            ew_curve_block curve = ew_bent_piece(path, i);
            ew_arc arc = ew_make_arc(segment, curve);
            arc.share = share;
#ifdef EW_WEIGHTS
            arc.place = domain.z;
            arc.place_slope = domain.w - domain.z;
#endif
            ew_cell first_cell = ew_cell_of_end(arc, arc.first, 1.0);
            ew_cell last_cell = ew_cell_of_end(arc, arc.last, -1.0);
            vec2 first, next_last;
            ew_find_parts(arc, first_cell, last_cell, part, first, next_last);
            sum += ew_add_stretches(arc, first_cell, last_cell, first, next_last, part, 0.0, others + max(sum, 0.0));
            if (i == 0) { start = first; has_start = true; }
            bool is_joint = i > 0 && i == done;
            vec2 weights = vec2(last_weight, ew_path_weight(path, domain.z));
            if (is_joint || (i == 0 && !is_closed))
                sum += ew_integrate_meeting(segment, ew_place_at(curve, arc.first), mix(first.xx, last, bvec2(is_joint)), first,
                                            mix(first.xx, chord, bvec2(is_joint)), weights, path.glow);
            last = next_last;
            last_weight = ew_path_weight(path, domain.w);
            end = ew_place_at(curve, arc.last);
            done = ++i;
            i = ew_find_piece(segment, path, i, chord, part);
        }
    } while (i < count && i < EW_MAX_PATH_PIECES);
    bool has_end = done == count && (has_start || !is_closed);
    vec2 weights = vec2(last_weight, mix(last_weight, ew_path_weight(path, 0.0), is_closed));
    vec2 next_first = mix(last.xx, start, bvec2(is_closed));
    vec2 whole = mix(last.xx, chord, bvec2(is_closed));
    float at_end = ew_integrate_meeting(segment, end, last, next_first, whole, weights, path.glow);
    return sum + mix(0.0, at_end, has_end);
}
#endif
