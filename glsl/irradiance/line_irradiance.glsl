// The light of an infinite line: of the part of it within the light's reach.
float ew_irradiance_of(const ew_surface surface, const ew_line_block line)
{
    vec3 axis = line.direction.xyz;
    vec3 foot = line.position.xyz - surface.position;
    foot -= dot(foot, axis) * axis;
    float reach = ew_light_reach();
    if (ew_length_squared(foot) >= reach * reach) return 0.0;
    float light = ew_light_of_straight(surface, foot, axis, vec2(-reach, reach), ew_light_core(line.glow));
    EW_PICK_BETWEEN(light, foot - reach * axis, foot + reach * axis);
    return light;
}
