// The closed form that everything rests on: the integral of a reciprocal distance whose square is quadratic along the ray.

// F(z) = (atanh(sqrt z) - sqrt z) / z^(3/2) = 1/3 + z/5 + z^2/7 + ..., for z in [0, 0.1]; error 1e-7.
float ew_atanh_series(float z)
{
    return 1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * (1.0 / 11.0 + z * (1.0 / 13.0)))));
}

// Integral over s in [from, to] of 1 / (sqrt(b2 + k (s - s0)^2) (s + beta)^2).
//
// In v = 1 / (s + beta), ds / (s + beta)^2 = -dv and v^2 (b2 + k (s - s0)^2) = c v^2 - 2 g v + k with sigma = s0 + beta,
// g = k sigma and c = b2 + k sigma^2. With d the root and q = (v_from - v_to) / (v_from d_from + v_to d_to) the integral is
//
//     q (v_from + v_to) + 2 g q^3 F(c q^2),
//
// in which nothing cancels while g >= 0. Where the ray passes the source closely, c q^2 nears 1; there atanh is half the
// logarithm of a quotient, all factors of which are sums of positive numbers. Relative error 1e-6.
float ew_integrate_reciprocal(float b2, float k, float s0, float from, float to)
{
    float beta = ew_frame.decay.x;
    float sigma = s0 + beta;
    float g = k * sigma;
    float c = b2 + g * sigma;
    float y_from = from - s0;
    float y_to = to - s0;
    float depth_from = from + beta;
    float depth_to = to + beta;
    float d_from = sqrt(b2 + k * y_from * y_from);
    float d_to = sqrt(b2 + k * y_to * y_to);
    float q = (to - from) / max(depth_to * d_from + depth_from * d_to, 1e-30); // an empty interval may lie at d = 0

    // exp(|u|) up to common factors, where sinh u = (b2 - g y) / ((s + beta) sqrt(b2 k)) is the substitution's variable.
    float inverse_root_c = inversesqrt(max(c, 1e-30));
    float root_c = c * inverse_root_c;
    float e_from = b2 - g * y_from;
    float e_to = b2 - g * y_to;
    float a_from = abs(e_from) + d_from * root_c;
    float a_to = abs(e_to) + d_to * root_c;
    float numerator = (e_from >= 0.0 ? a_from : depth_from) * (e_to >= 0.0 ? depth_to : a_to);
    float denominator = (e_from >= 0.0 ? depth_from : a_from) * (e_to >= 0.0 ? a_to : depth_to);
    if (e_from >= 0.0 && e_to < 0.0) denominator *= b2 * k;

    float z = c * q * q;
    float third = z < 0.1 ? q * q * q * ew_atanh_series(z)
                          : (0.5 * log(numerator / denominator) * inverse_root_c - q) * (inverse_root_c * inverse_root_c);
    return q * (depth_from + depth_to) / (depth_from * depth_to) + 2.0 * g * third;
}

// Integral over s in [from, to] of 1 / (max(epsilon, sqrt(b2 + k (s - s0)^2)) (s + beta)^2): the core, in which the field is
// constant, and the two sides of it.
float ew_integrate_line_distance(float b2, float k, float s0, float from, float to)
{
    float beta = ew_frame.decay.x;
    float epsilon = ew_frame.decay.y;
    float half_core = sqrt(max(epsilon * epsilon - b2, 0.0) / k);
    float core_from = clamp(s0 - half_core, from, to);
    float core_to = clamp(s0 + half_core, from, to);
    if (core_from == core_to) core_from = core_to = to;
    float sum = (core_to - core_from) / (epsilon * (core_from + beta) * (core_to + beta));
    // A loop and not two calls: most rays have no far side, and SIMD groups of them then skip it.
    int sides = core_to < to ? 2 : 1;
    for (int side = 0; side < sides; ++side) {
        sum += ew_integrate_reciprocal(b2, k, s0, from, core_from);
        from = core_to;
        core_from = to;
    }
    return sum;
}

// Where a ray passes a source closely: the squared distance b2 + k (s - s0)^2 that agrees with the source's there in value, slope
// and curvature, and the source's weight.
struct ew_passage {
    bool is_touching; // it does agree; else it is just another part of the source
    float b2;
    float k;
    float s0;
    float weight;
};

// The most panels of an interval's quadrature, refused ones included.
const int EW_MAX_PANELS = 400;
// How much the second difference of a panel's values counts beside the third in the estimate of its error. Weights are pieces of
// parabolas, of which the quadrature makes no error.
#ifdef EW_WEIGHTS
const float EW_SECOND_DIFFERENCE = 0.01;
#else
const float EW_SECOND_DIFFERENCE = 0.03;
#endif
// The length of the first panel beside a peak, in half widths of the peak, and how much longer than one panel the next may be.
const float EW_FIRST_PANEL = 10.0;
const float EW_PANEL_GROWTH = 3.0;

// The difference of weight / max(epsilon, d) of the source and of the passage at s.
float ew_reciprocal_difference(ew_passage passage, float s, float distance_squared, float weight)
{
    float epsilon2 = ew_square(ew_frame.decay.y);
    float model = passage.b2 + passage.k * ew_square(s - passage.s0);
    ew_evaluation_count += 1;
    return weight * inversesqrt(max(distance_squared, epsilon2)) - passage.weight * inversesqrt(max(model, epsilon2));
}
