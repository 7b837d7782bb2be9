// What is mirrored of a circle: of its chords, which are shorter where the circle is near. They take even steps of theta as in
// torus_irradiance.glsl, but with a ratio that is not so small that those on the far side get long.
float ew_gloss_of(const ew_surface surface, const ew_gloss gloss, const ew_torus_block torus)
{
    const int chords = 32;
    const float step = 3.14159265359 / float(chords);
    ew_circle circle = ew_circle_around(surface, torus);
    float ratio = max(circle.distances.x / max(circle.distances.y, 1e-30), 0.25);
    float core = ew_light_core(torus.glow);
    vec3 from = ew_circle_place(circle, vec2(-1.0, 0.0));
    float sum = 0.0;
    for (int i = 1; i <= chords; ++i) {
        vec3 to = ew_circle_place(circle, ew_turn_circle(ratio, step * float(i - chords / 2)).xy);
        sum += ew_gloss_of_segment(surface, gloss, from, to, core, vec4(0.0));
        from = to;
    }
    return circle.distances.x < ew_light_reach() ? sum : 0.0;
}
