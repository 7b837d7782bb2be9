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

ew_circle ew_circle_around(const ew_surface surface, const ew_torus_block torus)
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
vec3 ew_circle_place(const ew_circle circle, const vec2 turned)
{
    return circle.center + circle.radius * (turned.x * circle.right + turned.y * circle.up);
}

// From t = tan(phi / 2).
vec3 ew_circle_place_at(const ew_circle circle, const float t)
{
    return ew_circle_place(circle, vec2((1.0 - t) * (1.0 + t), 2.0 * t) / (1.0 + t * t));
}

// The light of a part next to the nearest place, where the surface is in the core: as straight ones.
float ew_light_of_near_arc(const ew_surface surface, const ew_circle circle, const vec2 part, const float core)
{
    float sum = 0.0;
    float half_step = 0.5 * (part.y - part.x) / float(EW_NEAR_CHORDS);
    for (int i = 0; i < EW_NEAR_CHORDS; ++i) {
        float middle = part.x + half_step * float(2 * i + 1);
        vec3 start = ew_circle_place_at(circle, middle - half_step);
        vec3 end = ew_circle_place_at(circle, middle + half_step);
        float light = ew_light_of_nearly_straight(surface, start, ew_circle_place_at(circle, middle), end, core);
        EW_PICK_BETWEEN(light, start, end);
        sum += light;
    }
    return sum;
}

// cos and sin of phi at theta. tan(phi / 2) is `ratio` times tan(theta). Also returns the phi that a radian of theta takes.
vec3 ew_turn_circle(const float ratio, const float theta)
{
    float c = cos(theta);
    float s = ratio * sin(theta);
    return vec3((c - s) * (c + s), 2.0 * c * s, 2.0 * ratio) / (c * c + s * s);
}

// The same of a part on one side of the nearest place. Next to that, where the surface is in the core, is no part of this kind, and the
// core is what 1 / d is smooth over.
float ew_light_of_arc(const ew_surface surface, const ew_circle circle, const vec2 part, const float core)
{
    float ratio = clamp(max(circle.distances.x, core) / max(circle.distances.y, 1e-30), 1e-6, 1.0);
    vec2 angles = atan(part / ratio);
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

// What stands for an infinite t, at the farthest place.
const float EW_FARTHEST_TURN = 1e6;

// Where the circle rises above the surface's horizon and where it falls below it again, which may be at a smaller t: then it is above at
// the farthest place. All of it, if it does neither. With t = tan(phi / 2),
//
//     n . (C - P) (1 + t^2) = away t^2 + 2 slope t + here
//
// which keeps the digits next to the nearest place. Those of an acos, or of Mesa's atan, would not tell where in a thin core that is.
vec2 ew_find_risen_arc(const ew_surface surface, const ew_circle circle)
{
    vec3 outward = circle.radius * circle.right;
    float here = dot(surface.normal, circle.center + outward);
    float away = dot(surface.normal, circle.center - outward);
    float slope = circle.radius * dot(surface.normal, circle.up);
    float discriminant = slope * slope - here * away;
    if (discriminant <= 0.0) return vec2(-EW_FARTHEST_TURN, EW_FARTHEST_TURN);
    float q = max(abs(slope) + sqrt(discriminant), 1e-30);
    float near = here / q;
    float far = q / mix(away, 1e-30, away == 0.0);
    vec2 arc = clamp(slope < 0.0 ? vec2(far, near) : vec2(-near, -far), -EW_FARTHEST_TURN, EW_FARTHEST_TURN);
    // The farthest place is both of these.
    return vec2(arc.x >= EW_FARTHEST_TURN ? -EW_FARTHEST_TURN : arc.x, arc.y <= -EW_FARTHEST_TURN ? EW_FARTHEST_TURN : arc.y);
}

float ew_irradiance_of(const ew_surface surface, const ew_torus_block torus)
{
    ew_circle circle = ew_circle_around(surface, torus);
    if (circle.distances.x >= ew_light_reach()) return 0.0;
    float level = dot(surface.normal, circle.center);
    vec2 lean = circle.radius * vec2(dot(surface.normal, circle.right), dot(surface.normal, circle.up));
    if (level + length(lean) <= 0.0) return 0.0;
    // Parts end at the nearest place and, from a surface in the core, where the circle next to that is taken as straight and where it
    // leaves the core.
    float core = ew_light_core(torus.glow);
    vec2 d2 = circle.distances * circle.distances;
    float core2 = core * core;
    float width = d2.x < core2 ? min(0.5 * core / circle.radius, 0.25) : 0.0;
    float edge = d2.x < core2 && core2 < d2.y ? max(sqrt((core2 - d2.x) / (d2.y - core2)), width) : width;
    vec2 arc = ew_find_risen_arc(surface, circle);
    float t = arc.x;
    float sum = 0.0;
    bool is_last = false;
    int count = 0;
    do {
        float next = t < -edge ? -edge : t < -width ? -width : t < 0.0 ? 0.0 : t < width ? width : t < edge ? edge : EW_FARTHEST_TURN;
        is_last = arc.y > t && arc.y <= next;
        vec2 part = vec2(t, is_last ? arc.y : next);
        sum += max(-part.x, part.y) <= width ? ew_light_of_near_arc(surface, circle, part, core)
                                             : ew_light_of_arc(surface, circle, part, core);
        t = next >= EW_FARTHEST_TURN ? -EW_FARTHEST_TURN : next;
    } while (!is_last && ++count < 10);
    return sum;
}
