#version 330 core

in vec4 vertex_color;
out vec4 result;

void main()
{
    result = vertex_color;
}
