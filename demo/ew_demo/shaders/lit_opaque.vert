#version 330 core

uniform mat4 view_projection;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;

out vec3 surface_position;
out vec3 surface_normal;
out vec3 surface_color;

void main()
{
    surface_position = position;
    surface_normal = normal;
    surface_color = color;
    gl_Position = view_projection * vec4(position, 1.0);
}
