// The closed form on which all sources rest: the integral of a reciprocal distance whose square is quadratic along the ray.
// docs/method.md, section 3, has the derivation.

// F(z) = (atanh(sqrt z) - sqrt z) / z^(3/2) = 1/3 + z/5 + z^2/7 + ..., for w = 1 - z in (0, 1].
//
// Near w = 0 it grows like -log(w) / 2. One polynomial in w plus log w times another is the usual form for approximations of
// complete elliptic integrals. Relative error 4e-7.
float ew_atanh_remainder(float w)
{
    float regular = -0.30684891 + w * (-0.20458833 + w * (0.02000992 + w * (0.56809512 + w * 0.25666545)));
    float singular = 0.34657341 + w * (0.51913897 + w * (0.60583716 + w * (0.39220929 + w * 0.05375421)));
    return regular - log2(w) * singular;
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
float ew_integrate_reciprocal(float b2, float k, float s0, float from, float to)
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
    float half_cosine = product >= 0.0 ? sum + b2 : b2 * (1.0 + (b2 + k * (y_from * y_from + y_to * y_to)) / sum);
    float depth_product = depth_from * depth_to;
    float w = clamp(2.0 * depth_product * half_cosine * inverse * inverse, 1e-37, 1.0);
    return q * ((depth_from + depth_to) / depth_product + 2.0 * k * (s0 + beta) * q * q * ew_atanh_remainder(w));
}

// The integral over s in [from, to] of 1 / (max(epsilon, sqrt(b2 + k (s - s0)^2)) (s + beta)^2): the core, in which the field
// is constant, and what lies before and behind it. Relative error 1e-6, like the closed form's.
float ew_integrate_floored_reciprocal(float b2, float k, float s0, float from, float to)
{
    float beta = ew_beta();
    float epsilon = ew_epsilon();
    float half_core = sqrt(max(epsilon * epsilon - b2, 0.0) / k);
    float core_from = clamp(s0 - half_core, from, to);
    float core_to = clamp(s0 + half_core, from, to);
    if (core_from == core_to) core_from = core_to = to;
    float sum = (core_to - core_from) / (epsilon * (core_from + beta) * (core_to + beta));
    if (EW_IS_NEEDED(from < core_from)) sum += ew_integrate_reciprocal(b2, k, s0, from, core_from);
    if (core_to < to) sum += ew_integrate_reciprocal(b2, k, s0, core_to, to);
    return sum;
}
