// The light of a point, which is closed.
float ew_irradiance_of(const ew_surface surface, const ew_point_block point)
{
    float core = ew_light_core(point.glow);
    vec3 offset = point.position.xyz - surface.position;
    float light = core * ew_light_at(surface, offset, core);
    EW_PICK_BETWEEN(light, offset, offset);
    return light;
}
