// The light of a circle. With phi the angle from the place that is nearest to the surface,
//
//     d^2 = h^2 cos^2(phi / 2) + g^2 sin^2(phi / 2),
//
// h and g the least and the largest distance. tan(phi / 2) = (h / g) tan(theta) makes 1 / d as smooth as can be, and there are six
// nodes of Gauss and Legendre in theta over each part of what of the circle is above the surface's horizon. That is an
// arc about the direction in which the normal leans.
float ew_irradiance_of(ew_surface surface, ew_torus_block torus)
{
    const float nodes[6] = float[6](-0.9324695142, -0.6612093865, -0.2386191861, 0.2386191861, 0.6612093865, 0.9324695142);
    const float gauss_weights[6] =
        float[6](0.1713244924, 0.3607615730, 0.4679139346, 0.4679139346, 0.3607615730, 0.1713244924);
    const float pi = 3.14159265359;
    float radius = ew_radius(torus);
    float core = torus.glow.x;
    vec3 axis = torus.axis.xyz;
    vec3 to_center = torus.center.xyz - surface.position;
    float height = dot(to_center, axis);
    vec3 inward = to_center - height * axis;
    float from_axis = length(inward);
    vec3 any_right = normalize(cross(axis, mix(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), bvec3(abs(axis.x) > 0.6))));
    vec3 right = mix(any_right, -inward / max(from_axis, 1e-30), bvec3(from_axis > 0.0));
    vec3 up = cross(axis, right);
    float nearest = sqrt(ew_square(from_axis - radius) + height * height);
    float farthest = sqrt(ew_square(from_axis + radius) + height * height);
    if (nearest >= ew_light_reach()) return 0.0;
    // n . (C - P) = level + lean cos(phi - toward).
    float level = dot(surface.normal, to_center);
    vec2 lean = radius * vec2(dot(surface.normal, right), dot(surface.normal, up));
    float slope = length(lean);
    if (level + slope <= 0.0) return 0.0;
    float toward = slope > 0.0 ? atan(lean.y, lean.x) : 0.0;
    float open = level >= slope ? pi : acos(clamp(-level / max(slope, 1e-30), -1.0, 1.0));
    float ratio = max(nearest / max(farthest, 1e-30), 1e-6);
    // From toward - open to toward + open: phi = turn + local, and local in [-pi, pi]. Parts end at the nearest place, and where the circle
    // next to that is taken as straight, since the surface is in the core.
    float width = nearest < core ? min(core / radius, 0.5) : 0.0;
    float turn = 2.0 * pi * floor(0.5 * (toward - open) / pi + 0.5);
    float local = toward - open - turn;
    float sum = 0.0;
    int count = 0;
    do {
        float next = local < -width ? -width : local < 0.0 ? 0.0 : local < width ? width : pi;
        next = min(next, toward + open - turn);
        if (max(-local, next) <= width) {
            vec3 start = to_center + radius * (cos(local) * right + sin(local) * up);
            vec3 middle = to_center + radius * (cos(0.5 * (local + next)) * right + sin(0.5 * (local + next)) * up);
            vec3 end = to_center + radius * (cos(next) * right + sin(next) * up);
            sum += ew_light_of_nearly_straight(surface, start, middle, end, core) / radius;
        } else {
            vec2 tangents = vec2(local <= -pi ? -1e6 : tan(0.5 * local), next >= pi ? 1e6 : tan(0.5 * next));
            vec2 angles = atan(tangents / ratio);
            float half_angle = 0.5 * (angles.y - angles.x);
            float mean_angle = 0.5 * (angles.x + angles.y);
            for (int i = 0; i < 6; ++i) {
                float theta = mean_angle + half_angle * nodes[i];
                float c = cos(theta);
                float s = ratio * sin(theta);
                float norm = c * c + s * s;
                // cos and sin of phi, from those of phi / 2.
                vec2 place = vec2((c - s) * (c + s), 2.0 * c * s) / norm;
                vec3 offset = to_center + radius * (place.x * right + place.y * up);
                sum += half_angle * gauss_weights[i] * 2.0 * ratio / norm * ew_light_at(surface, offset, core);
            }
        }
        if (next >= pi) { turn += 2.0 * pi; next = -pi; }
        local = next;
    } while (turn + local < toward + open && ++count < 8);
    return radius * sum;
}
