#version 330 core

uniform vec2 pixel; // the size of a pixel in clip space

layout(location = 0) in vec2 position; // in pixels, from the upper left corner
layout(location = 1) in vec4 color;

out vec4 vertex_color;

void main()
{
    vertex_color = color;
    gl_Position = vec4(position.x * pixel.x - 1.0, 1.0 - position.y * pixel.y, 0.0, 1.0);
}
