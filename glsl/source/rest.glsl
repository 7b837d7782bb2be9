// What the passage leaves of weight / max(epsilon, distance): the rest, and an estimate of how far it is from a parabola.

// Factor on the second difference in the error estimate of a panel that holds the core's edge.
const float EW_KINK = 6.0;
// Share of the second difference of the nearest point's place in the error estimate, for arcs with weights.
const float EW_PLACE_SHARE = 0.35;

// The reciprocal distances 1 / max(epsilon, d) at one place, of the arc and of its passage, and tau of the arc's nearest point.
struct ew_reciprocals {
    float source;
    float model;
    float tau;
};

ew_reciprocals ew_reciprocals_at(const ew_arc arc, const ew_passage passage, const float s)
{
    float epsilon2 = ew_arc_core2(arc, s);
    float tau = ew_tau_on_arm(arc, s);
    float model = passage.b2 + passage.k * ew_square(s - passage.s0);
    float distance_squared = ew_arc_distance_squared(arc, arc.start + s * arc.direction, tau);
    ew_evaluation_count += 1;
#ifdef EW_REACH
    float source = inversesqrt(max(distance_squared, epsilon2));
    bool is_in_core = s > passage.core.x && s < passage.core.y;
    return ew_reciprocals(source, mix(inversesqrt(max(model, 1e-30)), source, is_in_core), tau);
#else
    return ew_reciprocals(inversesqrt(max(distance_squared, epsilon2)), inversesqrt(max(model, epsilon2)), tau);
#endif
}

// The second difference of values at a panel's four nodes, up to a factor.
float ew_second_difference(const vec4 values)
{
    return abs(values.x - values.y - values.z + values.w);
}

// The rest at the nodes, and a measure of the second differences of all that it consists of.
struct ew_rest {
    vec4 values;
    float curvature;
};

#ifdef EW_WEIGHTS
// The rest of weight / distance, from the places `tau` of the nearest points, which are all in weight piece `piece`.
// `curvature` is that of source - model.
ew_rest ew_weighted_rest(const ew_arc arc, const ew_passage passage, const vec4 source, const vec4 model, const vec4 tau,
                         const float piece, const float curvature)
{
    vec3 polynomial = ew_weight_piece(int(arc.first_piece + piece)).polynomial.xyz;
    vec4 place = clamp((arc.place + (tau - arc.first) * arc.place_slope) * arc.piece_count - piece, 0.0, 1.0);
    vec4 weight = polynomial.x + place * (polynomial.y + place * polynomial.z);
    float slope = abs(polynomial.y) + abs(polynomial.z);
    float largest = max(max(weight.x, weight.y), max(weight.z, weight.w));
    return ew_rest(weight * source - passage.weight * model,
                   curvature * largest + EW_PLACE_SHARE * slope * ew_second_difference(place) * source.y);
}
#endif

#ifndef EW_REACH
// The factor on the second difference, which sees best the kink at the edge of the core: 1 if the nodes are all in it or all
// outside.
float ew_kink_factor(const ew_arc arc, vec4 source, const vec4 s)
{
#ifdef EW_CORE_PIXELS
    vec4 core2 = vec4(ew_arc_core2(arc, s.x), ew_arc_core2(arc, s.y), ew_arc_core2(arc, s.z), ew_arc_core2(arc, s.w));
    source *= sqrt(core2);
    float core = 1.0;
#else
    float core = 1.0 / arc.glow.x;
#endif
    float nearest = max(max(source.x, source.y), max(source.z, source.w));
    float farthest = min(min(source.x, source.y), min(source.z, source.w));
    return mix(1.0, EW_KINK, nearest > (1.0 - 1e-6) * core && farthest < (1.0 - 1e-6) * core);
}
#endif

// The rest at four places s, all of which have their nearest points in weight piece `piece`.
ew_rest ew_rest_at(const ew_arc arc, const ew_passage passage, const vec4 s, const float piece)
{
    ew_reciprocals at_x = ew_reciprocals_at(arc, passage, s.x);
    ew_reciprocals at_y = ew_reciprocals_at(arc, passage, s.y);
    ew_reciprocals at_z = ew_reciprocals_at(arc, passage, s.z);
    ew_reciprocals at_w = ew_reciprocals_at(arc, passage, s.w);
    vec4 source = vec4(at_x.source, at_y.source, at_z.source, at_w.source);
    vec4 model = vec4(at_x.model, at_y.model, at_z.model, at_w.model);
    ew_rest rest;
    rest.values = source - model;
    rest.curvature = ew_second_difference(rest.values);
#ifdef EW_WEIGHTS
    if (arc.piece_count > 0.0) {
        vec4 tau = vec4(at_x.tau, at_y.tau, at_z.tau, at_w.tau);
#ifdef EW_REACH
        float inverse_reach = ew_inverse_reach(arc.glow);
        rest = ew_weighted_rest(arc, passage, source - inverse_reach, model - inverse_reach, tau, piece, rest.curvature);
#else
        rest = ew_weighted_rest(arc, passage, source, model, tau, piece, rest.curvature);
#endif
    }
#endif
#ifndef EW_REACH
    rest.curvature *= ew_kink_factor(arc, source, s);
#endif
    return rest;
}
