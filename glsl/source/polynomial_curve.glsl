// Curves as polynomials, and the roots of cubics: appendix A.

// The curve as (8) has it, C(tau) = c2 tau^2 + c1 tau + c0.
struct ew_polynomial_curve {
    vec3 c0;
    vec3 c1;
    vec3 c2;
    bool has_vertex; // at c0: c1 and c2 are perpendicular
    float first;
    float last;
};

float ew_cube_root(const float x)
{
    return sign(x) * pow(abs(x), 1.0 / 3.0);
}

// The real roots of x^3 + a x^2 + b x + c = 0, appendix A with its misprints mended: theta = atan2(sqrt(-r), -q), u and v
// paired so that u v = -p, and each root shifted by -a/3. Where there is one real root, it is returned three times.
vec3 ew_cubic_roots(const float a, const float b, const float c)
{
    float p = b / 3.0 - a * a / 9.0;
    float q = a * a * a / 27.0 - a * b / 6.0 + c / 2.0;
    float r = p * p * p + q * q;
    float shift = -a / 3.0;
    if (r >= 0.0) {
        float u = ew_cube_root(q > 0.0 ? -q - sqrt(r) : -q + sqrt(r));
        return vec3((u == 0.0 ? 0.0 : u - p / u) + shift);
    }
    float theta = atan(sqrt(-r), -q);
    vec3 angles = (vec3(0.0, 1.0, 2.0) * 6.28318530718 + theta) / 3.0;
    return 2.0 * sqrt(-p) * cos(angles) + shift;
}

ew_polynomial_curve ew_make_polynomial_curve(const ew_curve_block block)
{
    ew_polynomial_curve curve;
    curve.c0 = block.origin.xyz;
    curve.c1 = ew_slope_x(block) * block.axis_x.xyz + ew_slope_y(block) * block.axis_y.xyz;
    curve.c2 = ew_bend(block) * block.axis_y.xyz;
    curve.has_vertex = ew_slope_y(block) == 0.0 && ew_bend(block) > 0.0;
    curve.first = ew_first_tau(block);
    curve.last = ew_last_tau(block);
    return curve;
}
