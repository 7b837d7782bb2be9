#version 330 core
// Nothing but multiply-adds, each of which needs the one before: sixteen chains of them, so that the next chain fills the time that
// one takes, and so many in a row that the loop itself costs little.
uniform int rounds;
uniform vec4 factor; // near 1, and not known to the compiler
out float result;

#define ONCE a = a * factor.x + factor.y; b = b * factor.x + factor.y; c = c * factor.x + factor.y; d = d * factor.x + factor.y;
#define FOUR_TIMES ONCE ONCE ONCE ONCE

void main()
{
    vec4 a = gl_FragCoord.xyxy;
    vec4 b = a + 1.0;
    vec4 c = a + 2.0;
    vec4 d = a + 3.0;
    for (int i = 0; i < rounds; ++i) {
        FOUR_TIMES FOUR_TIMES FOUR_TIMES FOUR_TIMES
    }
    vec4 sum = a + b + c + d;
    result = sum.x + sum.y + sum.z + sum.w;
}
