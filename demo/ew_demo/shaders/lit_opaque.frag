#version 330 core

// The layers of the court's stone, which compose.frag puts together once the energy has lit them: moonlight with shadows, and
// skylight with ambient occlusion. Every shape is a box with a rounding radius, and a sphere is a box of no extent. With these,
// shadow and occlusion need no maps.

const int MAX_SHAPES = 64;

uniform int shape_count;
uniform vec4 shape_center[MAX_SHAPES]; // w: the rounding radius
uniform vec4 shape_extent[MAX_SHAPES];
uniform vec3 eye;
uniform vec3 to_moon;
uniform bool is_mirrored;

in vec3 surface_position;
in vec3 surface_normal;
in vec3 surface_color;
layout(location = 0) out vec4 albedo_layer; // a: how far the court has faded into the dark
layout(location = 1) out vec4 own_layer;    // rgb: the light of moon and sky that it throws back, less the albedo; a: what it mirrors
layout(location = 2) out vec4 normal_layer;

float distance_to_shapes(vec3 place)
{
    float nearest = 1e9;
    for (int i = 0; i < shape_count; ++i) {
        vec3 outside = abs(place - shape_center[i].xyz) - shape_extent[i].xyz;
        float inside = min(max(outside.x, max(outside.y, outside.z)), 0.0);
        nearest = min(nearest, length(max(outside, 0.0)) + inside - shape_center[i].w);
    }
    return nearest;
}

// The part of the sky that a surface sees: all of it, if a step along its normal leads as far away from every other shape.
float openness(vec3 place, vec3 normal)
{
    const vec3 steps = vec3(0.25, 0.7, 1.6);
    const vec3 shares = vec3(0.45, 0.35, 0.3);
    float hidden = 0.0;
    for (int i = 0; i < 3; ++i)
        hidden += shares[i] * (1.0 - clamp(distance_to_shapes(place + steps[i] * normal) / steps[i], 0.0, 1.0));
    return clamp(1.0 - hidden, 0.0, 1.0);
}

// The part of the moon that is visible. A shape hides more, the longer the chord that it cuts out of the ray. The farther away
// the shape, the slower this grows, which softens the shadow's edge.
float moonlight(vec3 place)
{
    float seen = 1.0;
    for (int i = 0; i < shape_count; ++i) {
        vec3 center = shape_center[i].xyz - place;
        vec3 extent = shape_extent[i].xyz;
        float radius = shape_center[i].w;
        float enter, leave;
        if (radius > 0.0) {
            float along = dot(center, to_moon);
            float across2 = dot(center, center) - along * along;
            float half_chord = sqrt(max(0.0, radius * radius - across2));
            enter = along - half_chord;
            leave = along + half_chord;
        } else {
            vec3 a = (center - extent) / to_moon;
            vec3 b = (center + extent) / to_moon;
            vec3 first = min(a, b);
            vec3 last = max(a, b);
            enter = max(first.x, max(first.y, first.z));
            leave = min(last.x, min(last.y, last.z));
        }
        float chord = leave - max(enter, 0.0);
        seen *= 1.0 - smoothstep(0.0, 0.04 + 0.09 * max(enter, 0.0), chord);
    }
    return seen;
}

// The slabs of the floor and the steps. Their joints fade out where they are narrower than a pixel.
float joints(vec3 place, vec3 normal)
{
    const float side = 1.65;
    vec2 at = place.xz / side;
    vec2 width = fwidth(at);
    vec2 from_joint = abs(fract(at - 0.5) - 0.5);
    vec2 joint = (1.0 - smoothstep(vec2(0.008), vec2(0.014) + width, from_joint)) * clamp(0.03 / width, 0.0, 1.0);
    return 1.0 - 0.55 * max(joint.x, joint.y) * step(0.9999, normal.y);
}

void main()
{
    if (is_mirrored && surface_position.y < 0.001) discard;
    vec3 normal = normalize(surface_normal);
    vec3 to_eye = normalize(eye - surface_position);
    vec3 above = surface_position + 0.01 * normal;
    float open = openness(surface_position, normal);
    vec3 sky = mix(vec3(0.004, 0.005, 0.007), vec3(0.010, 0.015, 0.026), 0.5 + 0.5 * normal.y) * open;
    vec3 moon = vec3(0.055, 0.072, 0.11) * max(0.0, dot(normal, to_moon)) * moonlight(above);
    float slab = joints(surface_position, normal);
    vec3 albedo = surface_color * slab;
    float fresnel = 0.04 + 0.5 * pow(1.0 - max(0.0, dot(normal, to_eye)), 4.0);
    bool is_floor = surface_position.y < 0.001 && normal.y > 0.9;
    // The court ends in darkness, wherever the eye is.
    float dusk = 1.0 - exp(-pow(length(surface_position.xz) / 30.0, 3.0));
    albedo_layer = vec4(albedo, dusk);
    own_layer = vec4(albedo * (sky + moon) - albedo, is_floor ? (0.3 + 0.7 * fresnel) * slab : 0.0);
    normal_layer = vec4(normal, 0.0);
}
