#version 330 core
// The depth of four pixels as one: the nearest and the farthest by turns, in a chequered pattern, so that on either side of a
// silhouette there is a sample to filter with.
uniform sampler2D depth;
out float half_depth;

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(depth, 0) - 1;
    float a = texelFetch(depth, min(2 * place, last), 0).r;
    float b = texelFetch(depth, min(2 * place + ivec2(1, 0), last), 0).r;
    float c = texelFetch(depth, min(2 * place + ivec2(0, 1), last), 0).r;
    float d = texelFetch(depth, min(2 * place + ivec2(1, 1), last), 0).r;
    bool nearest = ((place.x ^ place.y) & 1) == 0;
    half_depth = nearest ? min(min(a, b), min(c, d)) : max(max(a, b), max(c, d));
}
