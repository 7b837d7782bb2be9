#version 330 core
// Nothing but multiply-adds, each of which needs the one before: sixteen chains of them, as many as hide the time that each takes.
uniform int rounds;
uniform vec4 factor; // near 1, and not known to the compiler
out float result;

void main()
{
    vec4 a = gl_FragCoord.xyxy;
    vec4 b = a + 1.0;
    vec4 c = a + 2.0;
    vec4 d = a + 3.0;
    for (int i = 0; i < rounds; ++i) {
        a = a * factor + factor;
        b = b * factor + factor;
        c = c * factor + factor;
        d = d * factor + factor;
    }
    vec4 sum = a + b + c + d;
    result = sum.x + sum.y + sum.z + sum.w;
}
