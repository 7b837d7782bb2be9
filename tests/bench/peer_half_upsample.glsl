#version 330 core
// Depth-aware upsampling, a joint bilateral filter (Kopf et al. 2007): the four samples around a pixel, each by how near to the
// pixel it is on the screen and in depth. Where none is near in depth, the nearest one counts.
uniform sampler2D light;
uniform sampler2D half_depth;
uniform sampler2D depth;
uniform vec4 projection; // the matrix's elements 10, 14, 11 and 15, which make depth of view depth
uniform bool has_depth;
out float filtered;

const float DEPTH_TOLERANCE = 0.02; // of the view depth

float view_depth(float window_depth)
{
    float ndc = 2.0 * window_depth - 1.0;
    return (projection.y - ndc * projection.w) / (projection.x - ndc * projection.z);
}

void main()
{
    ivec2 last = textureSize(light, 0) - 1;
    vec2 place = 0.5 * gl_FragCoord.xy - 0.5;
    ivec2 first = ivec2(floor(place));
    float own = has_depth ? view_depth(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r) : 1.0;
    float sum = 0.0;
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 tap = first + ivec2(i & 1, i >> 1);
        ivec2 inside = clamp(tap, ivec2(0), last);
        vec2 tent = 1.0 - abs(vec2(tap) - place);
        float other = has_depth ? view_depth(texelFetch(half_depth, inside, 0).r) : 1.0;
        float away = (other - own) / (DEPTH_TOLERANCE * own);
        float weight = tent.x * tent.y * exp(-min(away * away, 80.0)) + 1e-9 / (1.0 + away * away);
        sum += weight * texelFetch(light, inside, 0).r;
        weights += weight;
    }
    filtered = sum / weights;
}
