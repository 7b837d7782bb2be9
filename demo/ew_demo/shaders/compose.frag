#version 330 core

// Puts the layers of the court's stone together: see lit_opaque.frag. The energy has multiplied the albedo by 1 + E, so that this
// and the stone's own light, less the albedo, add up to all light that it throws back.

// Of the stone's tone mapping. The energy is drawn over it as the library gives it.
const float EXPOSURE = 1.6;

uniform sampler2D lit_albedo;
uniform sampler2D own_light;
uniform sampler2D reflection; // of any size
uniform bool reflects;
uniform vec3 background;
uniform vec2 pixel; // reciprocal of the picture's size

out vec4 result;

// What the floor reflects, smeared upwards because polished stone is not perfectly flat.
vec3 mirrored()
{
    vec2 at = gl_FragCoord.xy * pixel;
    vec3 sum = vec3(0.0);
    for (int i = -2; i <= 2; ++i)
        sum += texture(reflection, at + vec2(0.0, 0.004 * float(i))).rgb;
    return sum / 5.0;
}

void main()
{
    vec4 lit = texelFetch(lit_albedo, ivec2(gl_FragCoord.xy), 0);
    vec4 own = texelFetch(own_light, ivec2(gl_FragCoord.xy), 0);
    vec3 shown = 1.0 - exp(-EXPOSURE * max(lit.rgb + own.rgb, 0.0));
    // The reflection is as it is shown, light included.
    if (reflects) shown += (1.0 - shown) * own.a * mirrored();
    result = vec4(mix(shown, background, lit.a), 1.0);
}
