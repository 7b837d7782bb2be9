// What is mirrored of an infinite line: of the part of it within the light's reach.
float ew_gloss_of(const ew_surface surface, const ew_gloss gloss, const ew_line_block line)
{
    vec3 axis = line.direction.xyz;
    vec3 foot = line.position.xyz - surface.position;
    foot -= dot(foot, axis) * axis;
    vec3 way = ew_light_reach() * axis;
    return ew_gloss_of_segment(surface, gloss, foot - way, foot + way, ew_light_core(line.glow), vec4(0.0));
}
