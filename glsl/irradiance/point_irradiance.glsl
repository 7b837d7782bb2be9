// The light of a point, which is closed.
float ew_irradiance_of(ew_surface surface, ew_point_block point)
{
    float core = point.glow.x;
    return core * ew_light_at(surface, point.position.xyz - surface.position, core);
}
