// The light of the media themselves, and what they let through: equations (3) to (5) of Zsolnai and Szirmay-Kalos. Needs the ray of
// ew_enter_media.

#ifdef EW_FOG_HEIGHT
const int EW_MAX_LIGHT_PANELS = 64;
#endif

// The integral of the transmittance over a leg of the ray that was entered, from `from` to `to`, from where it begins.
float ew_integrate_transmittance(float from, const float to)
{
#ifdef EW_FOG_HEIGHT
    // By Gauss's rule, panel by panel.
    float sum = 0.0;
    int panel = 0;
    do {
        float size = min(ew_longest_in_fog(from, 1.0, 2.0), to - from);
        float middle = from + 0.5 * size;
        vec3 right = ew_transmittance(middle + 0.5 * size * EW_PANEL_NODES);
        vec3 left = ew_transmittance(middle - 0.5 * size * EW_PANEL_NODES);
        sum += 0.5 * size * dot(EW_PANEL_WEIGHTS, right + left);
        from = mix(from + size, to, size >= to - from);
    } while (from < to && ++panel < EW_MAX_LIGHT_PANELS);
    return sum;
#else
    // (1 - exp(-x)) / x of the optical depth x, times the way.
    float x = ew_optical_depth(vec4(to)).x;
    float series = 1.0 - x * (0.5 - x * (0.16666667 - x * (0.041666667 - x * 0.0083333333)));
    return (to - from) * mix((1.0 - exp(-min(x, 100.0))) / max(x, 0.05), series, x < 0.1);
#endif
}

// rgb: the light of the media along a segment, a: the share of what is behind it that they stop.
vec4 ew_integrate_media(const ew_segment segment)
{
    ew_enter_fog(segment);
    ew_enter_media(segment);
    vec3 light = vec3(0.0);
    float depth = 0.0;
    for (int leg = 0; leg < ew_leg_count; ++leg) {
        float from = ew_legs[leg].x;
        float to = ew_legs[leg + 1].x;
        vec3 source = vec3(0.0);
        for (int i = 0; i < ew_met_count; ++i) {
            float extinction = mix(0.0, ew_met_extinctions[i], ew_met_chords[i].x <= from && from < ew_met_chords[i].y);
            source += extinction * ew_media[ew_met_bodies[i]].light.rgb;
        }
        ew_enter_air(from, ew_legs[leg].y);
        light += source * ew_transmittance_of(vec4(ew_legs[leg].z)).x * ew_integrate_transmittance(from, to);
        depth += ew_legs[leg].y * (to - from);
    }
    ew_fog_begin = ew_legs[0].x;
    return vec4(light, 1.0 - exp(-min(depth, 100.0)));
}
