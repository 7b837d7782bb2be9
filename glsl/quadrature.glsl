// The closed form that everything rests on: the integral of a reciprocal distance whose square is quadratic along the ray.

// F(z) = (atanh(sqrt z) - sqrt z) / z^(3/2) = 1/3 + z/5 + z^2/7 + ... for small z; 1e-7 relative for z <= 0.1.
float ew_atanh_series(float z)
{
    return 1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * (1.0 / 11.0 + z * (1.0 / 13.0)))));
}

// Integral from s0 + near to s0 + far of 1 / (sqrt(b2 + k y^2) (s + beta)^2), y = s - s0; near <= far, all of it outside of y = 0
// if b2 = 0.
//
// In v = 1 / (s + beta), ds / (s + beta)^2 = -dv and v^2 (b2 + k y^2) = c v^2 - 2 g v + k with g = k (s0 + beta) and
// c = b2 + k (s0 + beta)^2. With D = v_near d_near + v_far d_far and q = (v_near - v_far) / D this is
//
//     q (v_near + v_far) + 2 g q^3 F(c q^2),
//
// in which nothing cancels while g >= 0. c q^2 nears 1 where the ray passes the source closely; there atanh is half the
// logarithm of a quotient, each factor of which is a sum of positive numbers.
float ew_integrate_reciprocal(float b2, float k, float s0, float near, float far)
{
    float beta = ew_frame.decay.x;
    float sigma = s0 + beta;
    float g = k * sigma;
    float c = b2 + g * sigma;
    float v_near = 1.0 / (sigma + near);
    float v_far = 1.0 / (sigma + far);
    float vd_near = v_near * sqrt(b2 + k * near * near);
    float vd_far = v_far * sqrt(b2 + k * far * far);
    float q = (far - near) * v_near * v_far / (vd_near + vd_far);
    float z = c * q * q;
    float third;
    if (z < 0.1) {
        third = q * q * q * ew_atanh_series(z);
    } else {
        // e = v c sinh(u) sqrt(b2 k) / c and a = |e| + v d sqrt c: exp(|u|) up to a factor.
        float root_c = sqrt(c);
        float e_near = v_near * (b2 - g * near);
        float e_far = v_far * (b2 - g * far);
        float a_near = abs(e_near) + vd_near * root_c;
        float a_far = abs(e_far) + vd_far * root_c;
        float ratio = (e_near >= 0.0 ? a_near : 1.0) * (e_far >= 0.0 ? 1.0 : a_far);
        ratio /= (e_near >= 0.0 ? 1.0 : a_near) * (e_far >= 0.0 ? a_far : 1.0);
        if (e_near >= 0.0 && e_far < 0.0) ratio /= b2 * k;
        third = (0.5 * log(ratio) / root_c - q) / c;
    }
    return q * (v_near + v_far) + 2.0 * g * third;
}

// Integral over s in [from, to] of 1 / (max(epsilon, sqrt(b2 + k (s - s0)^2)) (s + beta)^2): the line's core, in which the field
// is constant, and the two sides of it.
float ew_integrate_line_distance(float b2, float k, float s0, float from, float to)
{
    float epsilon = ew_frame.decay.z;
    float core2 = epsilon * epsilon - b2;
    float near = from - s0;
    float far = to - s0;
    if (core2 <= 0.0) return ew_integrate_reciprocal(b2, k, s0, near, far);
    float half_core = sqrt(core2 / k);
    float core_near = clamp(-half_core, near, far);
    float core_far = clamp(half_core, near, far);
    float sigma = s0 + ew_frame.decay.x;
    float sum = (core_far - core_near) / (epsilon * (sigma + core_near) * (sigma + core_far));
    if (core_near > near) sum += ew_integrate_reciprocal(b2, k, s0, near, core_near);
    if (core_far < far) sum += ew_integrate_reciprocal(b2, k, s0, core_far, far);
    return sum;
}
