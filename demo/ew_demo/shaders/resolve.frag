#version 330 core

// Averages a picture's samples and encodes it for a display.

uniform sampler2D color;
uniform int samples_per_axis;
uniform bool dithers;

out vec4 result;

vec3 srgb_encoded(vec3 linear)
{
    vec3 clipped = clamp(linear, 0.0, 1.0);
    return mix(12.92 * clipped, 1.055 * pow(clipped, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, clipped));
}

// Noise of one 8-bit step keeps dark gradients from banding: interleaved gradient noise (Jimenez 2014).
float noise(vec2 pixel)
{
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * samples_per_axis;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples_per_axis; ++y)
        for (int x = 0; x < samples_per_axis; ++x)
            sum += texelFetch(color, first + ivec2(x, y), 0).rgb;
    vec3 mean = sum / float(samples_per_axis * samples_per_axis);
    result = vec4(srgb_encoded(mean) + (dithers ? noise(gl_FragCoord.xy) / 255.0 : 0.0), 1.0);
}
