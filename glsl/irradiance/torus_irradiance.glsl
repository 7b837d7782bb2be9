// The light of a circle. With phi the angle from the place that is nearest to the surface,
//
//     d^2 = h^2 cos^2(phi / 2) + g^2 sin^2(phi / 2),
//
// h and g the least and the largest distance. tan(phi / 2) = (h / g) tan(theta) makes 1 / d as smooth as can be, and there are six
// nodes of Gauss and Legendre in theta over each part of what of the circle is above the surface's horizon. That is an
// arc about the direction in which the normal leans.

// A circle relative to the surface: C(phi) - P = center + radius (cos(phi) right + sin(phi) up), nearest at phi = 0. `right` and `up`
// are perpendicular unit vectors.
struct ew_circle {
    vec3 center;
    vec3 right;
    vec3 up;
    float radius;
    vec2 distances; // h and g
};

ew_circle ew_circle_around(ew_surface surface, ew_torus_block torus)
{
    vec3 axis = torus.axis.xyz;
    float radius = ew_radius(torus);
    vec3 to_center = torus.center.xyz - surface.position;
    float height = dot(to_center, axis);
    vec3 inward = to_center - height * axis;
    float from_axis = length(inward);
    vec3 any_right = normalize(cross(axis, mix(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), bvec3(abs(axis.x) > 0.6))));
    vec3 right = mix(any_right, -inward / max(from_axis, 1e-30), bvec3(from_axis > 0.0));
    vec2 distances = sqrt(vec2(ew_square(from_axis - radius), ew_square(from_axis + radius)) + height * height);
    return ew_circle(to_center, right, cross(axis, right), radius, distances);
}

// From the circle's cos(phi) and sin(phi).
vec3 ew_circle_place(ew_circle circle, vec2 turned)
{
    return circle.center + circle.radius * (turned.x * circle.right + turned.y * circle.up);
}

// The light of a part next to the nearest place, where the surface is in the core: as a straight one.
float ew_light_of_near_arc(ew_surface surface, ew_circle circle, vec2 part, float core)
{
    float middle = 0.5 * (part.x + part.y);
    vec3 start = ew_circle_place(circle, vec2(cos(part.x), sin(part.x)));
    vec3 end = ew_circle_place(circle, vec2(cos(part.y), sin(part.y)));
    vec3 between = ew_circle_place(circle, vec2(cos(middle), sin(middle)));
    float light = ew_light_of_nearly_straight(surface, start, between, end, core);
    EW_PICK_BETWEEN(light, start, end);
    return light;
}

// cos and sin of phi at theta. tan(phi / 2) is `ratio` times tan(theta). Also returns the phi that a radian of theta takes.
vec3 ew_turn_circle(float ratio, float theta)
{
    float c = cos(theta);
    float s = ratio * sin(theta);
    return vec3((c - s) * (c + s), 2.0 * c * s, 2.0 * ratio) / (c * c + s * s);
}

// The same of a part on one side, between -pi and 0 or between 0 and pi.
float ew_light_of_arc(ew_surface surface, ew_circle circle, vec2 part, float core)
{
    const float pi = 3.14159265359;
    float ratio = max(circle.distances.x / max(circle.distances.y, 1e-30), 1e-6);
    vec2 tangents = vec2(part.x <= -pi ? -1e6 : tan(0.5 * part.x), part.y >= pi ? 1e6 : tan(0.5 * part.y));
    vec2 angles = atan(tangents / ratio);
    float half_angle = 0.5 * (angles.y - angles.x);
    float mean_angle = 0.5 * (angles.x + angles.y);
    float sum = 0.0;
    for (int i = 0; i < 6; ++i) {
        vec3 turned = ew_turn_circle(ratio, mean_angle + half_angle * EW_EMITTER_NODES[i]);
        sum += EW_EMITTER_WEIGHTS[i] * turned.z * ew_light_at(surface, ew_circle_place(circle, turned.xy), core);
    }
#ifdef EW_SHADOWS
    vec4 shares = ew_shares_in_part(circle.radius * half_angle * sum);
    for (int i = 0; i < EW_PICK_COUNT; ++i)
        if (shares[i] >= 0.0 && shares[i] < 1.0)
            ew_picked[i] = ew_circle_place(circle, ew_turn_circle(ratio, mix(angles.x, angles.y, shares[i])).xy);
#endif
    return circle.radius * half_angle * sum;
}

float ew_irradiance_of(ew_surface surface, ew_torus_block torus)
{
    const float pi = 3.14159265359;
    ew_circle circle = ew_circle_around(surface, torus);
    if (circle.distances.x >= ew_light_reach()) return 0.0;
    // n . (C - P) = level + lean cos(phi - toward).
    float level = dot(surface.normal, circle.center);
    vec2 lean = circle.radius * vec2(dot(surface.normal, circle.right), dot(surface.normal, circle.up));
    float slope = length(lean);
    if (level + slope <= 0.0) return 0.0;
    float toward = slope > 0.0 ? atan(lean.y, lean.x) : 0.0;
    float open = level >= slope ? pi : acos(clamp(-level / max(slope, 1e-30), -1.0, 1.0));
    // From toward - open to toward + open: phi = turn + local, and local in [-pi, pi]. Parts end at the nearest place, and where
    // the circle next to that is taken as straight, since the surface is in the core.
    float core = ew_light_core(torus.glow);
    float width = circle.distances.x < core ? min(core / circle.radius, 0.5) : 0.0;
    float turn = 2.0 * pi * floor(0.5 * (toward - open) / pi + 0.5);
    float local = toward - open - turn;
    float sum = 0.0;
    int count = 0;
    do {
        float next = local < -width ? -width : local < 0.0 ? 0.0 : local < width ? width : pi;
        next = min(next, toward + open - turn);
        vec2 part = vec2(local, next);
        sum += max(-local, next) <= width ? ew_light_of_near_arc(surface, circle, part, core)
                                          : ew_light_of_arc(surface, circle, part, core);
        if (next >= pi) { turn += 2.0 * pi; next = -pi; }
        local = next;
    } while (turn + local < toward + open && ++count < 8);
    return sum;
}
