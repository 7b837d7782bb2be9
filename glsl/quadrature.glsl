// The closed form that everything rests on: the integral of a reciprocal distance whose square is quadratic along the ray.

// F(z) = (atanh(sqrt z) - sqrt z) / z^(3/2) = 1/3 + z/5 + z^2/7 + ..., for z in [0, 0.1]; error 1e-7.
float ew_atanh_series(float z)
{
    return 1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * (1.0 / 11.0 + z * (1.0 / 13.0)))));
}

// Integral over y in [near, far] of 1 / (sqrt(b2 + k y^2) (y + sigma)^2), where y + sigma > 0.
//
// In v = 1 / (y + sigma), dy / (y + sigma)^2 = -dv and v^2 (b2 + k y^2) = c v^2 - 2 g v + k with g = k sigma and c = b2 + k sigma^2.
// With d = sqrt(b2 + k y^2) and q = (v_near - v_far) / (v_near d_near + v_far d_far) the integral is
//
//     q (v_near + v_far) + 2 g q^3 F(c q^2),
//
// in which nothing cancels while g >= 0. Where the ray passes the source closely, c q^2 nears 1; there atanh is half the
// logarithm of a quotient, all factors of which are sums of positive numbers. Relative error 1e-6.
float ew_integrate_reciprocal(float b2, float k, float sigma, float near, float far)
{
    float g = k * sigma;
    float c = b2 + g * sigma;
    float depth_near = sigma + near;
    float depth_far = sigma + far;
    float d_near = sqrt(b2 + k * near * near);
    float d_far = sqrt(b2 + k * far * far);
    float q = (far - near) / max(depth_far * d_near + depth_near * d_far, 1e-30); // an empty interval may lie at d = 0

    // exp(|u|) up to common factors, where sinh u = (b2 - g y) / ((y + sigma) sqrt(b2 k)) is the substitution's variable.
    float inverse_root_c = inversesqrt(max(c, 1e-30));
    float root_c = c * inverse_root_c;
    float e_near = b2 - g * near;
    float e_far = b2 - g * far;
    float a_near = abs(e_near) + d_near * root_c;
    float a_far = abs(e_far) + d_far * root_c;
    float numerator = (e_near >= 0.0 ? a_near : depth_near) * (e_far >= 0.0 ? depth_far : a_far);
    float denominator = (e_near >= 0.0 ? depth_near : a_near) * (e_far >= 0.0 ? a_far : depth_far);
    if (e_near >= 0.0 && e_far < 0.0) denominator *= b2 * k;

    float z = c * q * q;
    float third = z < 0.1 ? q * q * q * ew_atanh_series(z)
                          : (0.5 * log(numerator / denominator) * inverse_root_c - q) * (inverse_root_c * inverse_root_c);
    return q * (depth_near + depth_far) / (depth_near * depth_far) + 2.0 * g * third;
}

// Integral over s in [from, to] of 1 / (max(epsilon, sqrt(b2 + k (s - s0)^2)) (s + beta)^2): the core, in which the field is
// constant, and the two sides of it.
float ew_integrate_line_distance(float b2, float k, float s0, float from, float to)
{
    float epsilon = ew_frame.decay.z;
    float sigma = s0 + ew_frame.decay.x;
    float near = from - s0;
    float far = to - s0;
    float half_core = sqrt(max(epsilon * epsilon - b2, 0.0) / k);
    float core_near = clamp(-half_core, near, far);
    float core_far = clamp(half_core, near, far);
    if (core_near == core_far) core_near = core_far = far;
    float sum = (core_far - core_near) / (epsilon * (sigma + core_near) * (sigma + core_far));
    // A loop and not two calls: most rays have no far side, and SIMD groups of them then skip it.
    int sides = core_far < far ? 2 : 1;
    for (int side = 0; side < sides; ++side) {
        sum += ew_integrate_reciprocal(b2, k, sigma, near, core_near);
        near = core_far;
        core_near = far;
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
    float epsilon2 = ew_square(ew_frame.decay.z);
    float model = passage.b2 + passage.k * ew_square(s - passage.s0);
    ew_evaluation_count += 1;
    return weight * inversesqrt(max(distance_squared, epsilon2)) - passage.weight * inversesqrt(max(model, epsilon2));
}
