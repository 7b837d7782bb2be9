// The light of a path: the sum of its pieces', since an emitter's ends add nothing of their own. Pieces that are small beside their
// distance from the surface take two nodes of Gauss and Legendre, which then are off by less than a hundredth of the piece's light.
// The others take what a single straight or bent emitter takes.

float ew_light_of_straight_piece(const ew_surface surface, const ew_path_block path, const vec4 start, const vec4 end)
{
    vec3 from = start.xyz - surface.position;
    vec3 to = end.xyz - surface.position;
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) {
        ew_emitter emitter =
            ew_emitter(from, to - from, vec3(0.0), vec2(0.0, 1.0), vec2(start.w, end.w - start.w), path.weights.xy, vec2(0.0),
                       vec2(0.0), vec2(0.0), 0.0);
        return ew_light_of_emitter(surface, emitter, false, ew_light_core(path.glow));
    }
#endif
    float light = ew_light_of_segment(surface, from, to, ew_light_core(path.glow));
    EW_PICK_BETWEEN(light, from, to);
    return light;
}

#ifdef EW_PIECES
// A piece relative to the surface: middle + u slope + u^2 bend, u from -1/2 to 1/2.
struct ew_short_piece {
    vec3 middle;
    vec3 slope;
    vec3 bend;
    vec2 weight_places; // of its ends
};

ew_short_piece ew_make_short_piece(const ew_surface surface, const ew_path_block path, const int i)
{
#ifdef EW_BENDS
    if (EW_HAS_BENDS(path)) {
        vec4 axis_x = ew_bent_unit(path, i, 1);
        vec4 axis_y = ew_bent_unit(path, i, 2);
        float bend = ew_bent_unit(path, i, 3).w;
        vec4 domain = ew_bent_unit(path, i, 4);
        float tau = 0.5 * (domain.x + domain.y);
        vec3 origin = ew_bent_unit(path, i, 0).xyz - surface.position;
        return ew_short_piece(origin + tau * axis_x.w * axis_x.xyz + tau * (axis_y.w + tau * bend) * axis_y.xyz,
                              axis_x.w * axis_x.xyz + (axis_y.w + 2.0 * tau * bend) * axis_y.xyz, bend * axis_y.xyz, domain.zw);
    }
#endif
    vec4 start = ew_straight_unit(path, i, 0);
    vec4 end = ew_straight_unit(path, i, 1);
    return ew_short_piece(0.5 * (start.xyz + end.xyz) - surface.position, end.xyz - start.xyz, vec3(0.0), vec2(start.w, end.w));
}

// Whether two nodes will do: not where the piece turns back, nor where its weights have a few polynomials.
bool ew_is_far(const ew_short_piece piece, const ew_path_block path)
{
    float slope = length(piece.slope);
    float bend = length(piece.bend);
    float radius = 0.5 * slope + 0.25 * bend;
    float knots = (piece.weight_places.y - piece.weight_places.x) * path.weights.y;
    return length(piece.middle) > max(3.0 * radius, radius + ew_light_core(path.glow)) && bend <= slope && knots <= 1.5;
}

float ew_light_of_far_piece(const ew_surface surface, const ew_path_block path, const ew_short_piece piece, const float core)
{
    const float node = 0.2886751346;
    vec3 outward = node * piece.slope;
    vec3 shifted = piece.middle + node * node * piece.bend;
    float light = 0.0;
    for (int side = -1; side <= 1; side += 2) {
        float u = float(side);
        float weight = ew_path_weight(path, mix(piece.weight_places.x, piece.weight_places.y, 0.5 + node * u));
        float speed = length(piece.slope + 2.0 * node * u * piece.bend);
        light += 0.5 * weight * speed * ew_light_at(surface, shifted + u * outward, core);
    }
    EW_PICK_ALONG(light, piece.middle - 0.5 * piece.slope, piece.slope);
    return light;
}

float ew_light_of_near_piece(const ew_surface surface, const ew_path_block path, const int i)
{
#ifdef EW_BENDS
    if (EW_HAS_BENDS(path))
        return ew_light_of_bend(surface, ew_bent_piece(path, i), ew_bent_unit(path, i, 4).zw, path.weights.xy);
#endif
    return ew_light_of_straight_piece(surface, path, ew_straight_unit(path, i, 0), ew_straight_unit(path, i, 1));
}

// Near pieces are looked for in a loop of their own: see EW_FIND in light.glsl.
float ew_light_of_near_pieces(const ew_surface surface, const ew_path_block path, const int first, const int last)
{
    float sum = 0.0;
    int i = first;
    do {
        bool is_near = false;
        do {
            is_near = is_near || !ew_is_far(ew_make_short_piece(surface, path, i), path);
            i += is_near ? 0 : 1;
        } while (!is_near && i <= last);
        if (is_near) {
            sum += ew_light_of_near_piece(surface, path, i);
            ++i;
        }
    } while (i <= last);
    return sum;
}

float ew_light_of_pieces(const ew_surface surface, const ew_path_block path, const int count)
{
    float core = ew_light_core(path.glow);
    float sum = 0.0;
    int first = count;
    int last = -1;
    int i = 0;
    do {
        ew_short_piece piece = ew_make_short_piece(surface, path, i);
        if (ew_is_far(piece, path)) {
            sum += ew_light_of_far_piece(surface, path, piece, core);
        } else {
            first = min(first, i);
            last = i;
        }
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    if (first <= last) sum += ew_light_of_near_pieces(surface, path, first, last);
    return sum;
}
#endif

float ew_irradiance_of(const ew_surface surface, const ew_path_block path)
{
#ifdef EW_PART
    if (!ew_is_of_part(path)) return 0.0;
#endif
    if (length(path.ball.xyz - surface.position) >= path.ball.w + ew_light_reach()) return 0.0;
#ifdef EW_PIECES
    if (!EW_IS_BEAM(path)) return ew_light_of_pieces(surface, path, int(path.pieces.y));
#endif
    vec4 start = vec4(path.ball.xyz - path.beam.xyz, 0.0);
    vec4 end = vec4(path.ball.xyz + path.beam.xyz, 1.0);
    return ew_light_of_straight_piece(surface, path, start, end);
}
