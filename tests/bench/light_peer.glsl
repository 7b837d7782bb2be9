#version 330 core

// As games light surfaces: a sum over point lights, which stand along the sources. Each has the falloff that the library has, so what
// is off is the sampling alone.

uniform sampler2D positions; // of surfaces, relative to the eye; w = 0: there is none
uniform sampler2D normals;
uniform sampler2D lights; // a row of places and cores, and one of colours times intensities
uniform int light_count;
uniform float light_reach;

out vec4 color;

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    vec4 position = texelFetch(positions, place, 0);
    vec3 normal = texelFetch(normals, place, 0).xyz;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count; ++i) {
        vec4 light = texelFetch(lights, ivec2(i, 0), 0);
        vec3 offset = light.xyz - position.xyz;
        float distance2 = max(dot(offset, offset), 1e-12);
        float least2 = max(distance2, light.w * light.w);
        float cut = max(1.0 - least2 / (light_reach * light_reach), 0.0);
        float falloff = max(dot(normal, offset), 0.0) * inversesqrt(distance2) * cut * cut / least2;
        sum += falloff * texelFetch(lights, ivec2(i, 1), 0).rgb;
    }
    color = vec4(position.w * sum, 0.0);
}
