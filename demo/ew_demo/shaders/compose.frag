#version 330 core

// Puts the layers of the court's stone together: see lit_opaque.frag. The energy has multiplied the albedo by 1 + E, so that this
// and the stone's own light, less the albedo, add up to all light that it throws back. Fog comes last: the library fogs the energy
// alike, and leaves the opaque scene to its host.

// Of the stone's tone mapping. The energy is drawn over it as the library gives it.
const float EXPOSURE = 1.6;

// Mist in the moonlight, as it is shown.
const vec3 FOG = vec3(0.013, 0.020, 0.034);

uniform sampler2D lit_albedo;
uniform sampler2D own_light;
uniform sampler2D reflection; // of any size
uniform bool reflects;
uniform vec3 background;
uniform vec2 pixel; // reciprocal of the picture's size
uniform sampler2D depth;
uniform vec2 depth_range; // view depths of the near plane and the far plane
uniform vec3 eye;
uniform vec3 ray;       // of view depth 1, through the middle of the picture
uniform vec3 ray_right; // what half of the picture to the right adds to it
uniform vec3 ray_up;    // and up
uniform float fog_extinction; // on the floor
uniform float fog_scale;

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

// The integral of the extinction of ew_fog, which the library takes along the same ray, from the eye to what is opaque, or to the
// far plane: the way times the mean of exp(-height / scale). The floor is taken to go on where the court's ends.
float optical_depth()
{
    vec2 at = 2.0 * gl_FragCoord.xy * pixel - 1.0;
    vec3 to_pixel = ray + at.x * ray_right + at.y * ray_up;
    float near = depth_range.x;
    float far = depth_range.y;
    float view_depth = near * far / (far - texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r * (far - near));
    if (to_pixel.y < 0.0) view_depth = min(view_depth, max(0.0, eye.y) / -to_pixel.y);
    float first = eye.y / fog_scale;
    float last = first + view_depth * to_pixel.y / fog_scale;
    float mean = abs(last - first) < 1e-2 ? exp(-0.5 * (first + last)) : (exp(-first) - exp(-last)) / (last - first);
    return fog_extinction * view_depth * length(to_pixel) * mean;
}

void main()
{
    vec4 lit = texelFetch(lit_albedo, ivec2(gl_FragCoord.xy), 0);
    vec4 own = texelFetch(own_light, ivec2(gl_FragCoord.xy), 0);
    vec3 shown = 1.0 - exp(-EXPOSURE * max(lit.rgb + own.rgb, 0.0));
    // The reflection is as it is shown, light included.
    if (reflects) shown += (1.0 - shown) * own.a * mirrored();
    result = vec4(mix(FOG, mix(shown, background, lit.a), exp(-optical_depth())), 1.0);
}
