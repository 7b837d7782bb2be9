// A sample of the field, for integrators that do nothing but sample it.

// (1 / max(epsilon, distance) - 1 / R) / (s + beta)^2, not negative: psi times zeta, (22). The world integral has no decay.
float ew_sample(const float distance_squared, const float s, const vec4 glow)
{
    ew_evaluation_count += 1;
#ifdef EW_REACH
    float field = max(inversesqrt(max(distance_squared, ew_core2(glow, s))) - ew_inverse_reach(glow), 0.0);
#else
    float field = 1.0;
    float distance = sqrt(max(distance_squared, ew_core2(glow, s)));
#endif
#ifdef EW_FOG
    field *= ew_transmittance(s);
#endif
#ifdef EW_WORLD
    return field;
#elif defined(EW_REACH)
    return field / ew_square(s + ew_beta());
#else
    return field / (distance * ew_square(s + ew_beta()));
#endif
}
