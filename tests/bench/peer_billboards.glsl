#version 330 core
// A billboard that turns to the eye.
layout(location = 0) in vec4 position_level;
layout(location = 1) in vec4 tangent_row;
layout(location = 2) in vec3 offset_reach;
uniform mat4 projection;
out vec2 place;
out float view_depth;
out float level;
flat out float row;
flat out float reach;

void main()
{
    vec3 position = position_level.xyz;
    vec3 to_eye = projection[3][3] == 0.0 ? normalize(-position) : vec3(0.0, 0.0, 1.0);
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), to_eye));
    vec3 up = cross(to_eye, right);
    vec3 corner = position + offset_reach.z * (offset_reach.x * right + offset_reach.y * up);
    place = offset_reach.xy;
    view_depth = -position.z;
    level = position_level.w;
    row = tangent_row.w;
    reach = offset_reach.z;
    gl_Position = projection * vec4(corner, 1.0);
}
