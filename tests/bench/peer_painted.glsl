#version 330 core
// The painted light of a billboard or a ribbon. It fades where the opaque scene is near, as soft particles do, over the part of the
// ray that is within a ball of the source's reach (spherical billboards: Umenhoffer, Szirmay-Kalos and Szijarto 2006).
uniform sampler2D profiles;
uniform float profile_count;
uniform sampler2D depth;
uniform bool has_depth;
uniform mat4 projection;
in vec2 place;            // from the middle, in reaches
in float view_depth;
in float level;
flat in float row;
flat in float reach;
out float light;

void main()
{
    float distance = length(place);
    if (distance >= 1.0) discard;
    light = level * texture(profiles, vec2(sqrt(distance), (row + 0.5) / profile_count)).r;
    if (has_depth) {
        float stored = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
        float ndc = 2.0 * stored - 1.0;
        float opaque = (projection[3][2] - ndc * projection[3][3]) / (projection[2][2] - ndc * projection[2][3]);
        float half_chord = reach * sqrt(1.0 - distance * distance);
        if (stored < 1.0) light *= smoothstep(-half_chord, half_chord, opaque - view_depth);
    }
}
