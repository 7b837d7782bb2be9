// A sample of the field, for integrators that do nothing but sample it.

// 1 / (max(epsilon, distance) (s + beta)^2): psi times zeta, (22).
float ew_sample(float distance_squared, float s)
{
    float epsilon = ew_epsilon();
    ew_evaluation_count += 1;
    return 1.0 / (sqrt(max(distance_squared, epsilon * epsilon)) * ew_square(s + ew_beta()));
}
