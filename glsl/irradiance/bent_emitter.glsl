// Emitters that are bent or have weights: six nodes of Gauss and Legendre in the angle under which the surface sees the emitter,
// between the places where the integrand is not smooth. These are the surface's horizon, the vertex of the parabola, beyond
// which another place is nearest, and the knots of the weights.

// A quadratic emitter relative to the surface, C(tau) - P = (c2 tau + c1) tau + c0 with tau in domain; the weight at tau is the one
// at place + tau slope of its list, of which `pieces` has the first piece and their number.
struct ew_emitter {
    vec3 c0;
    vec3 c1;
    vec3 c2;
    vec2 domain;
    vec2 weight_place;
    vec2 pieces;
    vec2 peaks; // the tau nearest to the surface before the vertex, and behind it
    vec2 sharp; // these again where no rule may run across them; else the end
    vec2 widths; // how far to either side of them the emitter is taken as straight, since the surface is in its core
    float vertex;
};

vec3 ew_emitter_place(const ew_emitter emitter, const float tau)
{
    return (emitter.c2 * tau + emitter.c1) * tau + emitter.c0;
}

float ew_emitter_weight(const ew_emitter emitter, const float tau)
{
#ifdef EW_WEIGHTS
    if (emitter.pieces.y > 0.0)
        return ew_weight(emitter.weight_place.x + tau * emitter.weight_place.y, emitter.pieces.x, emitter.pieces.y);
#endif
    return 1.0;
}

// The next knot of the weights behind tau, or `last`. The place along the list grows with tau.
float ew_emitter_knot(const ew_emitter emitter, const float tau, const float last)
{
#ifdef EW_WEIGHTS
    float per_tau = emitter.pieces.y * emitter.weight_place.y;
    if (per_tau > 0.0) {
        float knot = emitter.pieces.y * emitter.weight_place.x + tau * per_tau;
        // Rounding may leave the last knot itself just ahead.
        float next = (floor(knot + 1e-3) + 1.0 - knot) / per_tau + tau;
        return next < last - 1e-3 / per_tau ? next : last;
    }
#endif
    return last;
}

// How much tau changes on a way along the emitter from the peak on. The way grows with its speed and, from a sharp vertex, with its bend.
float ew_tau_of_way(const ew_emitter emitter, const float peak, const float way)
{
    float speed = length(emitter.c1 + 2.0 * peak * emitter.c2);
    return 2.0 * way / max(speed + sqrt(speed * speed + 4.0 * way * length(emitter.c2)), 1e-30);
}

// The integral between two tau of one smooth part. tau = peak + width tan(theta) spreads the nodes evenly over the angle under
// which a straight emitter would be seen, from a place in the core over that from the core's edge: what is nearer is no part of this
// kind.
float ew_light_of_part(const ew_surface surface, const ew_emitter emitter, const vec2 part, const float core)
{
    float middle = 0.5 * (part.x + part.y);
    float peak = clamp(middle < emitter.vertex ? emitter.peaks.x : emitter.peaks.y, part.x, part.y);
    float nearest = max(length(ew_emitter_place(emitter, peak)), core);
    float width = max(ew_tau_of_way(emitter, peak, nearest), 1e-6 * (part.y - part.x));
    vec2 angles = atan((part - peak) / width);
    float half_angle = 0.5 * (angles.y - angles.x);
    float mean_angle = 0.5 * (angles.x + angles.y);
    float sum = 0.0;
    for (int i = 0; i < 6; ++i) {
        float tangent = tan(mean_angle + EW_EMITTER_NODES[i] * half_angle);
        float tau = peak + width * tangent;
        float step = width * (1.0 + tangent * tangent) * length(emitter.c1 + 2.0 * tau * emitter.c2);
        sum += EW_EMITTER_WEIGHTS[i] * step * ew_emitter_weight(emitter, tau) *
               ew_light_at(surface, ew_emitter_place(emitter, tau), core);
    }
#ifdef EW_SHADOWS
    vec4 shares = ew_shares_in_part(half_angle * sum);
    for (int i = 0; i < EW_PICK_COUNT; ++i)
        if (shares[i] >= 0.0 && shares[i] < 1.0)
            ew_picked[i] = ew_emitter_place(emitter, peak + width * tan(mix(angles.x, angles.y, shares[i])));
#endif
    return half_angle * sum;
}

// The integral over a part in whose core the surface is, as straight ones.
float ew_light_of_near_part(const ew_surface surface, const ew_emitter emitter, const vec2 part, const float core)
{
    float sum = 0.0;
    float half_step = 0.5 * (part.y - part.x) / float(EW_NEAR_CHORDS);
    for (int i = 0; i < EW_NEAR_CHORDS; ++i) {
        float middle = part.x + half_step * float(2 * i + 1);
        vec3 start = ew_emitter_place(emitter, middle - half_step);
        vec3 end = ew_emitter_place(emitter, middle + half_step);
        float light = ew_emitter_weight(emitter, middle) *
                      ew_light_of_nearly_straight(surface, start, ew_emitter_place(emitter, middle), end, core);
        EW_PICK_BETWEEN(light, start, end);
        sum += light;
    }
    return sum;
}

// How far from the peak the emitter leaves the core, if the surface is in it there; else 0.
float ew_straight_width(const ew_emitter emitter, const float peak, const float core)
{
    bool is_near = ew_length_squared(ew_emitter_place(emitter, peak)) < core * core;
    return is_near ? ew_tau_of_way(emitter, peak, core) : 0.0;
}

// The peak, where the surface is close to it for the core's size or for the emitter's length; else what is no place of the emitter.
float ew_sharp_peak(const ew_emitter emitter, const float peak, const float core)
{
    float nearest = length(ew_emitter_place(emitter, peak));
    bool is_sharp = nearest < 2.0 * core || ew_tau_of_way(emitter, peak, nearest) < 0.1 * (emitter.domain.y - emitter.domain.x);
    return is_sharp ? peak : emitter.domain.y;
}

// The tau nearest to the surface before the vertex and behind it. With C2 perpendicular to C1, the derivative of the squared distance
// is a cubic without a square term; its least root and its largest are minima.
void ew_find_peaks(inout ew_emitter emitter, const bool has_vertex, const float core)
{
    float cubic = 2.0 * ew_length_squared(emitter.c2);
    float quadratic = 3.0 * dot(emitter.c1, emitter.c2);
    float linear = 2.0 * dot(emitter.c2, emitter.c0) + ew_length_squared(emitter.c1);
    float constant = dot(emitter.c1, emitter.c0);
    vec2 peaks = vec2(-constant / max(ew_length_squared(emitter.c1), 1e-30));
    if (has_vertex) {
        vec3 roots = ew_cubic_roots(0.0, linear / cubic, constant / cubic);
        peaks = vec2(min(min(roots.x, min(roots.y, roots.z)), 0.0), max(max(roots.x, max(roots.y, roots.z)), 0.0));
    }
    // Where terms cancel, single precision leaves the roots too far off.
    for (int i = 0; i < 3; ++i) {
        vec2 slope = (3.0 * cubic * peaks + 2.0 * quadratic) * peaks + linear;
        peaks -= (((cubic * peaks + quadratic) * peaks + linear) * peaks + constant) / max(slope, vec2(0.1 * abs(linear) + 1e-30));
    }
    emitter.vertex = has_vertex ? 0.0 : emitter.domain.x;
    vec2 first = vec2(emitter.domain.x, max(emitter.vertex, emitter.domain.x));
    vec2 last = vec2(has_vertex ? min(emitter.vertex, emitter.domain.y) : emitter.domain.y, emitter.domain.y);
    emitter.peaks = clamp(peaks, min(first, last), last);
    emitter.sharp = vec2(ew_sharp_peak(emitter, emitter.peaks.x, core), ew_sharp_peak(emitter, emitter.peaks.y, core));
    emitter.widths = vec2(ew_straight_width(emitter, emitter.peaks.x, core), ew_straight_width(emitter, emitter.peaks.y, core));
}

// Where the emitter passes through the surface's horizon: the roots of n . (C - P), or `none` twice.
vec2 ew_find_horizon(const ew_surface surface, const ew_emitter emitter, const float none)
{
    float a = dot(surface.normal, emitter.c2);
    float b = dot(surface.normal, emitter.c1);
    float c = dot(surface.normal, emitter.c0);
    float discriminant = b * b - 4.0 * a * c;
    if (discriminant <= 0.0) return vec2(none);
    float q = -0.5 * (b + (b < 0.0 ? -sqrt(discriminant) : sqrt(discriminant)));
    return vec2(a == 0.0 ? none : q / a, q == 0.0 ? none : c / q);
}

// The first of the places, from tau on, where the integrand is not smooth.
float ew_next_break(const ew_emitter emitter, const vec2 horizon, const float tau)
{
    float next = ew_emitter_knot(emitter, tau, emitter.domain.y);
    vec4 near = vec4(emitter.peaks - emitter.widths, emitter.peaks + emitter.widths);
    vec4 breaks = vec4(horizon, emitter.sharp);
    bvec4 has_near = bvec4(emitter.widths.xyxy);
    near = mix(vec4(next), near, bvec4(has_near.x && near.x > tau, has_near.y && near.y > tau, has_near.x && near.z > tau, has_near.y && near.w > tau));
    breaks = mix(vec4(next), breaks, greaterThan(breaks, vec4(tau)));
    vec4 least = min(near, breaks);
    next = min(next, min(min(least.x, least.y), min(least.z, least.w)));
    return emitter.vertex > tau ? min(next, emitter.vertex) : next;
}

// How many parts an emitter has at the most: between its knots, its vertex, two roots of the horizon, what is next to its peaks, and its
// ends.
const int EW_MAX_EMITTER_PARTS = 1024 + 10;

float ew_light_of_emitter(const ew_surface surface, ew_emitter emitter, const bool has_vertex, const float core)
{
    ew_find_peaks(emitter, has_vertex, core);
    float last = emitter.domain.y;
    vec2 horizon = ew_find_horizon(surface, emitter, last);
    float sum = 0.0;
    float tau = emitter.domain.x;
    int count = 0;
    do {
        float next = ew_next_break(emitter, horizon, tau);
        float middle = 0.5 * (tau + next);
        if (any(lessThan(abs(emitter.peaks - middle), emitter.widths)))
            sum += ew_light_of_near_part(surface, emitter, vec2(tau, next), core);
        else if (dot(surface.normal, ew_emitter_place(emitter, middle)) > 0.0)
            sum += ew_light_of_part(surface, emitter, vec2(tau, next), core);
        tau = next;
    } while (tau < last && ++count < EW_MAX_EMITTER_PARTS);
    return sum;
}

// The emitter that a curve's block is, or a bent piece of a path. `weight_places`: where its ends are in the list of
// weights.
float ew_light_of_bend(const ew_surface surface, const ew_curve_block block, const vec2 weight_places, const vec2 pieces)
{
    ew_polynomial_curve curve = ew_make_polynomial_curve(block);
    float slope = weight_places.y - weight_places.x;
    vec2 places = vec2(weight_places.x - curve.first * slope, slope);
    ew_emitter emitter = ew_emitter(curve.c0 - surface.position, curve.c1, curve.c2, vec2(curve.first, curve.last), places, pieces, vec2(0.0), vec2(0.0), vec2(0.0), 0.0);
    return ew_light_of_emitter(surface, emitter, curve.has_vertex, ew_light_core(block.glow));
}
