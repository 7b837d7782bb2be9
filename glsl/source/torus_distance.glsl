// The distance to a torus, equation (7): the circle of a radius about an axis.

// The squared distance from `position`, and the weight at the nearest point: for integrators that sample the field.
float ew_distance_squared(const ew_torus_block torus, const vec3 position, out float weight)
{
    vec3 difference = position - torus.center.xyz;
    float height = dot(difference, torus.axis.xyz);
    float from_axis = length(difference - height * torus.axis.xyz);
    weight = 1.0;
    return ew_square(from_axis - ew_radius(torus)) + height * height;
}
