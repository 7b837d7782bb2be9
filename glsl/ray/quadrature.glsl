// The closed form on which all sources rest: the integral of a reciprocal distance whose square is quadratic along the ray.
// docs/method.md, section 3, has the derivation.

// F(z) = (atanh(sqrt z) - sqrt z) / z^(3/2) = 1/3 + z/5 + z^2/7 + ..., for w = 1 - z in (0, 1].
//
// Near w = 0 it grows like -log(w) / 2. One polynomial in w plus log w times another is the usual form for approximations of
// complete elliptic integrals. Relative error 4e-7.
float ew_atanh_remainder(const float w)
{
    float regular = -0.30684891 + w * (-0.20458833 + w * (0.02000992 + w * (0.56809512 + w * 0.25666545)));
    float singular = 0.34657341 + w * (0.51913897 + w * (0.60583716 + w * (0.39220929 + w * 0.05375421)));
    return regular - log2(w) * singular;
}

#ifdef EW_WORLD
// The integral over s in [from, to] of 1: how much the part of the ray counts.
float ew_measure(const float from, const float to)
{
    return to - from;
}

// The integral over s in [from, to] of 1 / sqrt(b2 + k (s - s0)^2), for b2 >= 0 and k > 0: with d the root and
// q = (to - from) / (d_from + d_to),
//
//     2 atanh(sqrt(k) q) / sqrt(k) = 2 q + 2 k q^3 F(k q^2),
//
// the limit of the papers' for a large beta. 1 - k q^2 is half_cosine over ((d_from + d_to) / 2)^2, written as there. Relative
// error 1e-6.
float ew_integrate_reciprocal(const float b2, const float k, const float s0, const float from, const float to)
{
    float y_from = from - s0;
    float y_to = to - s0;
    float d_from = sqrt(b2 + k * y_from * y_from);
    float d_to = sqrt(b2 + k * y_to * y_to);
    float inverse = 1.0 / max(d_from + d_to, 1e-30);
    float q = (to - from) * inverse;
    float product = k * y_from * y_to;
    float sum = d_from * d_to + abs(product);
    float half_cosine = mix(b2 * (1.0 + (b2 + k * (y_from * y_from + y_to * y_to)) / sum), sum + b2, product >= 0.0);
    float w = clamp(2.0 * half_cosine * inverse * inverse, 1e-37, 1.0);
    return 2.0 * q * (1.0 + k * q * q * ew_atanh_remainder(w));
}
#else
// The integral over s in [from, to] of 1 / (s + beta)^2: how much the part of the ray counts.
float ew_measure(const float from, const float to)
{
    return (to - from) / ((from + ew_beta()) * (to + ew_beta()));
}

// The integral over s in [from, to] of 1 / (sqrt(b2 + k (s - s0)^2) (s + beta)^2), for b2 >= 0, k > 0 and s0 >= -beta.
//
// With v = 1 / (s + beta), ds / (s + beta)^2 = -dv, and the squared distance times v^2 is c v^2 - 2 g v + k, where
// g = k (s0 + beta) and c = b2 + g (s0 + beta). Let d be the distance, depth = s + beta, and
// q = (to - from) / (depth_to d_from + depth_from d_to). Then the integral is
//
//     q (v_from + v_to) + 2 g q^3 F(c q^2),
//
// a sum of positive terms. F needs w = 1 - c q^2 without cancellation. w is cos^2 of half the angle between the directions from
// the source to the two ends, times positive factors. If the ends lie on different sides of s0, half_cosine would be a
// difference of nearly equal numbers; it is rewritten as b2 times a sum. Relative error 1e-6.
float ew_integrate_reciprocal(const float b2, const float k, const float s0, const float from, const float to)
{
    float beta = ew_beta();
    float y_from = from - s0;
    float y_to = to - s0;
    float depth_from = from + beta;
    float depth_to = to + beta;
    float d_from = sqrt(b2 + k * y_from * y_from);
    float d_to = sqrt(b2 + k * y_to * y_to);
    // The floor is for empty intervals at a place where d = 0.
    float inverse = 1.0 / max(depth_to * d_from + depth_from * d_to, 1e-30);
    float q = (to - from) * inverse;
    float product = k * y_from * y_to;
    float sum = d_from * d_to + abs(product);
    float half_cosine = mix(b2 * (1.0 + (b2 + k * (y_from * y_from + y_to * y_to)) / sum), sum + b2, product >= 0.0);
    float depth_product = depth_from * depth_to;
    float w = clamp(2.0 * depth_product * half_cosine * inverse * inverse, 1e-37, 1.0);
    return q * ((depth_from + depth_to) / depth_product + 2.0 * k * (s0 + beta) * q * q * ew_atanh_remainder(w));
}
#endif

#ifdef EW_CORE_PIXELS
// The core of b2 + k y^2, y = s - s0: where that is less than the squared radius of the core, which grows with depth. Its edges are
// roots of
//
//     (k - g) y^2 - 2 m y - e = 0,
//
// where g is the growth of r'^2 with y^2, 2 m that with y, and e what r'^2 has more than b2 at s0. With
// sum = |m| + sqrt(m^2 + (k - g) e) they are e / sum and sum / (k - g) with opposite signs, in which nothing cancels: the one that
// m points at is sum / (k - g). An empty core is [0, 0].
//
// Only a ray that looks along a line has k < g. Its core is around the light outside of it: before the nearer root and beyond the further
// one. If such a ray is in the core all the way, both are far behind it.
vec2 ew_find_core(const float b2, const float k, const float s0, const vec4 glow)
{
    float growth2 = ew_core_growth2();
    float middle = ew_frame.core_floor.x * ew_view_depth.y * (ew_view_depth.x + s0 * ew_view_depth.y);
    float excess = ew_core2(glow, s0) - b2;
    float a = k - growth2;
    float root2 = middle * middle + a * excess;
    float sum = abs(middle) + sqrt(max(root2, 0.0));
    float inner = clamp(excess / max(sum, 1e-30), -1e15, 1e15);
    float outer = min(sum / max(abs(a), 1e-30), 1e15);
    bool is_around = ew_is_around(k);
    vec2 behind = mix(vec2(-inner, outer), vec2(-outer, -inner), bvec2(is_around));
    vec2 before = mix(vec2(-outer, inner), vec2(inner, outer), bvec2(is_around));
    return mix(mix(before, behind, bvec2(middle >= 0.0)), vec2(mix(0.0, 1e15, is_around)), bvec2(root2 < 0.0));
}
#endif

// The same, whether cores are as wide as pixels or not.
vec2 ew_core_of(const float b2, const float k, const float s0, const vec4 glow)
{
#ifdef EW_CORE_PIXELS
    return ew_find_core(b2, k, s0, glow);
#else
    float half_core = sqrt(max(glow.x * glow.x - b2, 0.0) / k);
    return vec2(-half_core, half_core);
#endif
}

#ifdef EW_WORLD
// 2 atanh(x) / x of x2 = x^2 < 0.1. Relative error 1e-7.
float ew_atanh_series(const float x2)
{
    return 2.0 + x2 * (0.66666667 + x2 * (0.4 + x2 * (0.28571429 + x2 * (0.22222222 + x2 * 0.18181818))));
}

#ifdef EW_CORE_PIXELS
// The integral of 1 / r' over parts of a core, of each of which q is the size over the sum of r' at its ends: a closed form of its own, that
// of a reciprocal distance from the eye.
float ew_integrate_core(const float q)
{
    float x2 = ew_core_growth2() * q * q;
    float x = sqrt(x2);
    float logarithm = 0.69314718 * log2((1.0 + x) / max(1.0 - x, 1e-6)) / max(x, 1e-3);
    return q * mix(logarithm, ew_atanh_series(x2), x2 < 0.1);
}

// That over a part between whose ends r' grows from radius.x to radius.y or falls.
float ew_integrate_core(const vec2 radius, const float size)
{
    return ew_integrate_core(size / (radius.x + radius.y));
}

// That over two parts, by s: of their forms the sum is one, with (q + q') / (1 + g q q').
float ew_integrate_cores(const vec4 parts, const vec4 glow)
{
    vec4 radius = sqrt(vec4(ew_core2(glow, parts.x), ew_core2(glow, parts.y), ew_core2(glow, parts.z), ew_core2(glow, parts.w)));
    vec2 size = parts.yw - parts.xz;
    vec2 sum = radius.xz + radius.yw;
    return ew_integrate_core((size.x * sum.y + size.y * sum.x) / (sum.x * sum.y + ew_core_growth2() * size.x * size.y));
}
#endif

// The integral of 1 / sqrt(b2 + k y^2) over y, but for what is between core.x <= 0 and core.y >= 0. Of each side it is
// 2 atanh(sqrt(k) q) / sqrt(k) with q = length / (sum of the distances at its ends); the sum of both is again of that form, with
// (q + q') / (1 + k q q'). Where that is no small angle, it is the logarithm of
//
//     (d(y_after) + sqrt(k) y_after) / (d(y_before) - sqrt(k) y_before),   y_after = max(y, core.y), y_before = min(y, core.x),
//
// at the one end over the other: sums of positive terms.
float ew_integrate_outside(const float b2, const float k, const vec2 y, const vec2 core)
{
    float root_k = sqrt(k);
    vec2 after = max(y, core.yy);
    vec2 before = min(y, core.xx);
    vec2 d_after = sqrt(b2 + k * after * after);
    vec2 d_before = sqrt(b2 + k * before * before);
    vec2 length = vec2(after.y - after.x, before.y - before.x);
    vec2 sum = max(vec2(d_after.x + d_after.y, d_before.x + d_before.y), 1e-18);
    float q = (length.x * sum.y + length.y * sum.x) / (sum.x * sum.y + k * length.x * length.y);
    vec2 at_after = max(d_after + root_k * after, 1e-18);
    vec2 at_before = max(d_before - root_k * before, 1e-18);
    float power = (at_after.y * at_before.x) / (at_after.x * at_before.y);
    float x2 = k * q * q;
    return mix(0.69314718 * log2(power) / root_k, q * ew_atanh_series(x2), x2 < 0.1);
}

// The integral over s in [from, to] of 1 / r'. Relative error 1e-6.
float ew_integrate_core(const float from, const float to, const vec4 glow)
{
#ifdef EW_CORE_PIXELS
    return ew_integrate_core(sqrt(vec2(ew_core2(glow, from), ew_core2(glow, to))), to - from);
#else
    return (to - from) / glow.x;
#endif
}

// The integral over s in [from, to] of 1 / max(r', sqrt(b2 + k (s - s0)^2)): the core, and what lies before and behind it. Relative
// error 1e-6, of what a ray through the core has.
float ew_integrate_floored_reciprocal(const float b2, const float k, const float s0, const float from, const float to,
                                      const vec4 glow)
{
    vec2 y = vec2(from, to) - s0;
    vec2 core = ew_core_of(b2, k, s0, glow);
#ifdef EW_CORE_PIXELS
    // Around the light outside of it, there are two parts of a core.
    bvec2 is_around = bvec2(ew_is_around(k));
    vec2 edges = clamp(core, y.xx, y.yy);
    vec4 parts = vec4(mix(edges, vec2(y.x, edges.x), is_around), mix(edges.yy, vec2(edges.y, y.y), is_around));
    y = mix(y, max(min(y, core.yy), core.xx), is_around);
    core = mix(core, vec2(0.0), is_around);
    return ew_integrate_outside(b2, k, y, core) + ew_integrate_cores(s0 + parts, glow);
#else
    float sides = ew_integrate_outside(b2, k, y, core);
    vec2 inside = clamp(core, y.xx, y.yy);
    return sides + ew_integrate_core(s0 + inside.x, s0 + inside.y, glow);
#endif
}
#else
// The integral over s in [from, to] of 1 / (r' (s + beta)^2). Relative error 1e-6.
float ew_integrate_core(const float from, const float to, const vec4 glow)
{
#ifdef EW_CORE_PIXELS
    vec3 field = ew_field_in_core(glow, 0.0);
    return ew_integrate_reciprocal(field.x, field.y, field.z, from, to);
#else
    return ew_measure(from, to) / glow.x;
#endif
}

#ifdef EW_CORE_PIXELS
// The same with the decay 1 / (s + beta)^2. Relative error 1e-6.
float ew_integrate_floored_reciprocal(const float b2, const float k, const float s0, const float from, const float to,
                                      const vec4 glow)
{
    vec2 core = clamp(s0 + ew_find_core(b2, k, s0, glow), from, to);
    if (core.x == core.y) core = vec2(to);
    // The field before and behind these, and in between.
    vec3 outer = vec3(b2, k, s0);
    vec3 inner = ew_field_in_core(glow, s0);
    if (ew_is_around(k)) {
        outer = inner;
        inner = vec3(b2, k, s0);
    }
    float sum = 0.0;
    if (EW_IS_NEEDED(core.x < core.y)) sum += ew_integrate_reciprocal(inner.x, inner.y, inner.z, core.x, core.y);
    if (EW_IS_NEEDED(from < core.x)) sum += ew_integrate_reciprocal(outer.x, outer.y, outer.z, from, core.x);
    if (EW_IS_NEEDED(core.y < to)) sum += ew_integrate_reciprocal(outer.x, outer.y, outer.z, core.y, to);
    return sum;
}
#else
// The integral over s in [from, to] of 1 / (max(epsilon, sqrt(b2 + k (s - s0)^2)) (s + beta)^2), or without the decay: the core,
// in which the field is constant, and what lies before and behind it. Relative error 1e-6, like the closed form's.
float ew_integrate_floored_reciprocal(const float b2, const float k, const float s0, const float from, const float to,
                                      const vec4 glow)
{
    float epsilon = glow.x;
    float half_core = sqrt(max(epsilon * epsilon - b2, 0.0) / k);
    float core_from = clamp(s0 - half_core, from, to);
    float core_to = clamp(s0 + half_core, from, to);
    if (core_from == core_to) core_from = core_to = to;
    float sum = ew_integrate_core(core_from, core_to, glow);
    if (EW_IS_NEEDED(from < core_from)) sum += ew_integrate_reciprocal(b2, k, s0, from, core_from);
    if (core_to < to) sum += ew_integrate_reciprocal(b2, k, s0, core_to, to);
    return sum;
}
#endif
#endif

#ifndef EW_FOG
// The same, less 1 / R: what a source with a reach has between two places that are within it.
float ew_integrate_within_reach(const float b2, const float k, const float s0, const vec2 part, const vec4 glow)
{
    float sum = ew_integrate_floored_reciprocal(b2, k, s0, part.x, part.y, glow);
#ifdef EW_REACH
    sum -= ew_inverse_reach(glow) * ew_measure(part.x, part.y);
#endif
    return sum;
}

// In fog there is a slower one, which the ends of bent pieces need.
#define ew_integrate_by_rule ew_integrate_within_reach
#endif
