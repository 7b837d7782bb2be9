// Where a ray passes an arc most closely. The reciprocal distance has its peak there, which the closed form takes over.

// A squared distance b2 + k (s - s0)^2 that agrees with the arc's in value, slope and curvature at s0; and the arc's weight
// there.
struct ew_passage {
    bool is_touching; // they do agree; otherwise the point at s0 is not the arc's nearest
    float b2;
    float k;
    float s0;
    float weight;
#ifdef EW_REACH
    vec2 core; // where the arc's core begins and ends
#endif
};

// Half the second derivative of the squared distance along the ray, where the ray is nearest to the arc's point at `tau` and
// `across` leads to that point: |V|^2 - (C' . V)^2 / (|C'|^2 + (C - L) . C''), written without the difference. It is 0 at a
// centre of curvature, and is kept above 1e-7 |V|^2.
float ew_distance_curvature(const ew_arc arc, const float tau, const vec3 across, const float v2)
{
    float slope_y = arc.slope_y + 2.0 * arc.bend * tau;
    float bending = 2.0 * arc.bend * across.y;
    float slope2 = arc.slope_x * arc.slope_x + slope_y * slope_y;
    float sine2 = ew_square(arc.slope_x * arc.direction.y - slope_y * arc.direction.x) + slope2 * ew_square(arc.direction.z);
    return clamp((sine2 + v2 * bending) / max(slope2 + bending, 1e-30), 1e-7 * v2, v2);
}

// The passage at the parabola's point at `tau`. It is the passage of that single point if the point `is_end`, the nearest one
// all along, or `is_far` from any closest approach.
ew_passage ew_passage_at(const ew_arc arc, const float tau, const bool is_end, const bool is_far)
{
    vec3 difference = vec3(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau, 0.0) - arc.start;
    float v2 = ew_length_squared(arc.direction);
    float s0 = dot(difference, arc.direction) / v2;
    vec3 across = difference - s0 * arc.direction;
    float k = mix(ew_distance_curvature(arc, tau, across, v2), v2, is_end || is_far);
    bool is_touching = is_end || (tau > arc.first && tau < arc.last);
    float b2 = ew_length_squared(across);
    // A passage that does not touch gets no core: between the edge of its core and that of the arc's, the rest would be a spike
    // that the quadrature's nodes may miss.
    b2 = mix(max(b2, ew_arc_core2(arc, s0)), b2, is_touching);
#ifdef EW_REACH
    return ew_passage(is_touching, b2, k, s0, ew_arc_weight(arc, tau), vec2(s0));
#else
    return ew_passage(is_touching, b2, k, s0, ew_arc_weight(arc, tau));
#endif
}

// tau of the two minima of the whole parabola's distance from the ray, which may be one. Seen along the ray, the ray is a
// point, so they are roots of an equation like (12). It is scaled by |V|^2, so that projections become cross products and
// nothing cancels. Between two minima is the maximum, `farthest`; without, it is a minimum.
vec2 ew_closest_approaches(const ew_arc arc, out float farthest)
{
    vec3 moment = cross(arc.start, arc.direction);
    vec3 v = arc.direction;
    vec3 slope = vec3(arc.slope_y * v.z, -arc.slope_x * v.z, arc.slope_x * v.y - arc.slope_y * v.x);
    vec3 bend = arc.bend * vec3(v.z, 0.0, -v.x);
    float cubic = 2.0 * ew_length_squared(bend);
    float quadratic = 3.0 * dot(slope, bend);
    float linear = ew_length_squared(slope) - 2.0 * dot(bend, moment);
    float constant = dot(slope, moment);
    // Shifted to where the quadratic term vanishes, if that is near the arc.
    float middle = 0.5 * (arc.first + arc.last);
    float shift = clamp(-quadratic / max(3.0 * cubic, 1e-30), middle - 4.5, middle + 4.5);
    constant -= shift * (linear + shift * (quadratic + shift * cubic));
    linear += shift * (2.0 * quadratic + shift * 3.0 * cubic);
    quadratic += 3.0 * cubic * shift;
    vec2 minima = ew_distance_minima(cubic, quadratic, linear, constant);
    farthest = shift + mix(-quadratic / max(cubic, 1e-30) - minima.x - minima.y, minima.x, minima.x == minima.y);
    return shift + minima;
}

// The two closest approaches of the ray to the whole parabola, which may be one; and the s of the maximum between them.
struct ew_approaches {
    vec2 tau;
    vec2 s;
    float farthest;
};

ew_approaches ew_find_approaches(const ew_arc arc)
{
    float farthest;
    vec2 tau = ew_closest_approaches(arc, farthest);
    vec2 y = (arc.slope_y + arc.bend * tau) * tau;
    vec2 along = arc.slope_x * tau * arc.direction.x + y * arc.direction.y - dot(arc.start, arc.direction);
    float farthest_y = (arc.slope_y + arc.bend * farthest) * farthest;
    float farthest_along = arc.slope_x * farthest * arc.direction.x + farthest_y * arc.direction.y - dot(arc.start, arc.direction);
    float v2 = ew_length_squared(arc.direction);
    return ew_approaches(tau, along / v2, farthest_along / v2);
}

// The passage for a stretch around `middle` on which arc.arm is nearest, at whichever of its closest approaches is nearer.
// Beyond the tip of an arc that is folded back on itself (`is_fold`), it is that of the tip, one point all along, like an end.
ew_passage ew_passage_of_arm(const ew_arc arc, const ew_approaches approaches, const float middle, out bool is_fold)
{
    vec2 equation = arc.equation_start + middle * arc.equation_growth;
    bool is_either_arm = !arc.has_arms || equation.x >= 0.0;
    vec2 remoteness = abs(approaches.s - middle);
    remoteness.x += mix(0.0, 1e6, !is_either_arm && approaches.tau.x * arc.arm < 0.0);
    remoteness.y += mix(0.0, 1e6, !is_either_arm && approaches.tau.y * arc.arm < 0.0);
    float tau = mix(approaches.tau.x, approaches.tau.y, remoteness.y < remoteness.x);
    bool is_far = abs(tau - 0.5 * (arc.first + arc.last)) > 1.0;
    tau = mix(tau, clamp(tau, arc.first, arc.last), is_far);
    is_fold = arc.has_vertex && arc.slope_x == 0.0 && equation.x > 0.0;
    return ew_passage_at(arc, mix(tau, 0.0, is_fold), is_fold, is_far);
}
