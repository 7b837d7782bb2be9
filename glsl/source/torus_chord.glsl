// Where the segment may be within reach of a torus: a sphere around its reach.
vec2 ew_chord(const ew_segment segment, const ew_torus_block torus)
{
    return ew_sphere_chord(segment, torus.center.xyz, ew_radius(torus) + torus.glow.y);
}
