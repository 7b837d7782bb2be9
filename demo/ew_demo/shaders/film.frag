#version 330 core

// Composites the energy over the opaque scene, and encodes it for a display.

uniform sampler2D opaque_scene;
uniform sampler2D energy;
uniform bool soft;
uniform int samples_per_axis;
uniform bool graded;
uniform float sensitivity; // to the energy: about the reciprocal of its mean luminance
uniform bool encoded;

out vec4 result;

// The field falls off with only the first power of the distance, so a beam's light fills the room like haze. Film with a steep
// gradation keeps the cores and thins the haze. This look is the host's choice, made after the effect has been drawn.
const float WHITE = 1.75;
const float GRADATION = 6.0;

vec3 developed(vec3 light, vec3 behind)
{
    vec3 relative = light * sensitivity / WHITE;
    float strength = max(relative.r, max(relative.g, relative.b));
    vec3 glow = relative * pow(strength, GRADATION - 1.0);
    float veil = 1.0 - exp(-max(glow.r, max(glow.g, glow.b)));
    return 1.0 - exp(-1.6 * (behind * (1.0 - veil) + glow));
}

vec3 srgb_encoded(vec3 linear)
{
    vec3 clipped = clamp(linear, 0.0, 1.0);
    return mix(12.92 * clipped, 1.055 * pow(clipped, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, clipped));
}

// Noise of one 8-bit step keeps dark gradients from banding: interleaved gradient noise (Jimenez 2014).
float dither(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samples_per_axis;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples_per_axis; ++y)
        for (int x = 0; x < samples_per_axis; ++x) {
            vec3 behind = texelFetch(opaque_scene, first + ivec2(x, y), 0).rgb;
            vec4 light = texelFetch(energy, first + ivec2(x, y), 0);
            vec3 veil = soft ? light.rgb : light.aaa;
            sum += graded ? developed(light.rgb, behind) : behind * (1.0 - veil) + light.rgb;
        }
    vec3 mean = sum / float(samples_per_axis * samples_per_axis);
    result = vec4(encoded ? srgb_encoded(mean) + (graded ? dither(gl_FragCoord.xy) / 255.0 : 0.0) : mean, 1.0);
}
