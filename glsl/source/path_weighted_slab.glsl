// The light of a straight piece of a path that has weights, between its ends.

#ifdef EW_WEIGHTS
// Gauss's four nodes on [0, 1].
const vec4 EW_PATH_NODES = vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
const vec4 EW_PATH_NODE_WEIGHTS = vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);

// The weight on a part of the piece on which it is one polynomial of the place t along it: x + y (s - w) + z (s - w)^2 with w in the middle.
vec4 ew_weight_on_part(const ew_slab slab, const vec2 part, const vec3 weight_by_t)
{
    float middle = 0.5 * (part.x + part.y);
    float scale = (slab.t.y - slab.t.x) / max(slab.size, 1e-30);
    float base = slab.t.x + scale * (slab.along + middle * slab.growth);
    float slope = scale * slab.growth;
    return vec4(weight_by_t.x + base * (weight_by_t.y + base * weight_by_t.z), slope * (weight_by_t.y + 2.0 * base * weight_by_t.z),
                slope * slope * weight_by_t.z, middle);
}

#ifdef EW_FOG
// The same as ew_integrate_slab for a part of the piece on which the weight is one polynomial of the place along it.
float ew_integrate_weighted_part(const ew_segment segment, const ew_slab slab, vec2 part, const vec3 weight_by_t, const vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    vec4 weight = ew_weight_on_part(slab, part, weight_by_t);
    ew_evaluation_count += 1;
    vec2 core = s0 + ew_core_of(b2, k, s0, glow);
    return part.x < part.y ? ew_integrate_in_fog(b2, k, s0, part, core, ew_is_around(k), weight, glow) : 0.0;
}
#elif !defined(EW_WORLD)
// More panels than any part takes: they grow by factors.
const int EW_MAX_PATH_PANELS = 64;

// The same with the decay, by Gauss's rule in panels, each of which is in the core or outside of it. None is much longer than its distance from
// what is singular: there the rule errs by 4e-5. Relative error 1e-4.
float ew_integrate_weighted_part(const ew_segment segment, const ew_slab slab, vec2 part, const vec3 weight_by_t, const vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    vec4 weight = ew_weight_on_part(slab, part, weight_by_t);
    vec2 core = clamp(s0 + ew_core_of(b2, k, s0, glow), part.x, part.y);
    float sum = 0.0;
    float from = part.x;
    int panel = 0;
    do {
        bool is_between = from >= core.x && from < core.y;
        float stop = mix(mix(part.y, core.y, is_between), core.x, from < core.x);
        vec3 field = mix(vec3(b2, k, s0), ew_field_in_core(glow, s0), bvec3(is_between != ew_is_around(k)));
        float away = from - field.z;
        float size = min(max(max(1.5 * away, -0.6 * away), 1.2 * sqrt(field.x / field.y)), from + ew_beta());
        float to = min(from + size, stop);
        vec4 s = from + (to - from) * EW_PATH_NODES;
        vec4 x = s - weight.w;
        vec4 distance = s - field.z;
        vec4 depth = s + ew_beta();
        vec4 value = (weight.x + x * (weight.y + x * weight.z)) *
                     (inversesqrt(field.x + field.y * distance * distance) - ew_inverse_reach(glow)) / (depth * depth);
        sum += (to - from) * dot(EW_PATH_NODE_WEIGHTS, value);
        from = to;
    } while (from < part.y && ++panel < EW_MAX_PATH_PANELS);
    ew_evaluation_count += 4;
    return sum;
}
#else
// The integral over [from, to] of weight (1 / sqrt(b2 + k y^2) - 1 / reach) with y = s - s0: closed forms. Where the part is short, compared
// with the distance, they would be small differences, and all is smooth. The weight is weight.x + weight.y x + weight.z x^2 with
// x = s - weight.w. So it has its digits where s0 is far away, too, as on a ray along the piece.
float ew_integrate_weighted_field(const float b2, const float k, const float s0, const float from, const float to, const vec4 weight,
                                  const vec4 glow)
{
    float y_from = from - s0;
    float y_to = to - s0;
    float d_from = sqrt(b2 + k * y_from * y_from);
    float d_to = sqrt(b2 + k * y_to * y_to);
    float least2 = mix(b2, ew_square(min(d_from, d_to)), y_from * y_to > 0.0);
    vec4 s = from + (to - from) * EW_PATH_NODES;
    vec4 x = s - weight.w;
    vec4 at_nodes = weight.x + x * (weight.y + x * weight.z);
    float of_nodes = (to - from) * dot(EW_PATH_NODE_WEIGHTS, at_nodes * (inversesqrt(b2 + k * (s - s0) * (s - s0)) - ew_inverse_reach(glow)));
    float shift = s0 - weight.w;
    vec3 polynomial = vec3(weight.x + shift * (weight.y + shift * weight.z), weight.y + 2.0 * shift * weight.z, weight.z);
    float moment0 = ew_integrate_reciprocal(b2, k, s0, from, to);
    float moment1 = (to - from) * (y_from + y_to) / max(d_from + d_to, 1e-30);
    float moment2 = 0.5 * (y_to * d_to - y_from * d_from - b2 * moment0) / k;
    float way = y_to - y_from;
    vec3 at_reach = way * vec3(1.0, 0.5 * (y_to + y_from), (y_to * y_to + y_to * y_from + y_from * y_from) / 3.0);
    float of_moments = dot(polynomial, vec3(moment0, moment1, moment2) - ew_inverse_reach(glow) * at_reach);
    return mix(of_moments, of_nodes, k * ew_square(0.5 * (to - from)) < 0.1 * least2);
}

// The same as ew_integrate_slab for a part of the piece on which the weight is one polynomial of the place along it.
float ew_integrate_weighted_part(const ew_segment segment, const ew_slab slab, vec2 part, const vec3 weight_by_t, const vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    vec4 weight = ew_weight_on_part(slab, part, weight_by_t);
    vec2 core = clamp(s0 + ew_core_of(b2, k, s0, glow), part.x, part.y);
    float sum = 0.0;
    // The core, and what is before and behind it, or the other way round. A loop, because compilers put the integral into the shader for
    // every place that calls it.
    for (int i = 0; i < 3; ++i) {
        vec2 ends = mix(mix(vec2(part.x, core.x), core, bvec2(i == 1)), vec2(core.y, part.y), bvec2(i == 2));
        vec3 field = mix(vec3(b2, k, s0), ew_field_in_core(glow, s0), bvec3((i == 1) != ew_is_around(k)));
        if (ends.x < ends.y) sum += ew_integrate_weighted_field(field.x, field.y, field.z, ends.x, ends.y, weight, glow);
    }
    ew_evaluation_count += 1;
    return sum;
}
#endif

// The most knots of the weights that lie on one straight piece, and one.
const int EW_MAX_PIECE_KNOTS = 1024;

float ew_integrate_weighted_slab(const ew_segment segment, const ew_slab slab, const ew_path_block path, const vec2 part)
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
