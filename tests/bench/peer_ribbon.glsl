#version 330 core
// A ribbon along its source that turns about it to the eye. Where it is seen at an angle, the eye looks through more of the glow:
// as of an endless beam, 1 / sin times as much, which is bounded.
layout(location = 0) in vec4 position_level;
layout(location = 1) in vec4 tangent_row;
layout(location = 2) in vec3 offset_reach;
uniform mat4 projection;
out vec2 place;
out float view_depth;
out float level;
flat out float row;
flat out float reach;

const float LEAST_SINE = 0.25;

void main()
{
    vec3 position = position_level.xyz;
    vec3 to_eye = projection[3][3] == 0.0 ? normalize(-position) : vec3(0.0, 0.0, 1.0);
    vec3 side = cross(tangent_row.xyz, to_eye);
    float sine = length(side);
    side /= max(sine, 1e-6);
    vec3 onward = cross(to_eye, side);
    vec3 corner = position + offset_reach.z * (offset_reach.x * side + offset_reach.y * onward);
    place = offset_reach.xy;
    view_depth = -position.z;
    level = position_level.w / max(sine, LEAST_SINE);
    row = tangent_row.w;
    reach = offset_reach.z;
    gl_Position = projection * vec4(corner, 1.0);
}
