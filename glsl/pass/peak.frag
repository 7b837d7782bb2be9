// The largest B of EW_PEAK_SIZE x EW_PEAK_SIZE nodes; or of as many of these peaks.

uniform sampler2D ew_node_texture;
uniform ivec2 ew_source_size;

out vec4 ew_peak;

void main()
{
    ivec2 first = ivec2(gl_FragCoord.xy) * EW_PEAK_SIZE;
    ivec2 last = ew_source_size - 1;
    float peak = 0.0;
    for (int y = 0; y < EW_PEAK_SIZE; ++y)
        for (int x = 0; x < EW_PEAK_SIZE; ++x)
            peak = max(peak, texelFetch(ew_node_texture, min(first + ivec2(x, y), last), 0).a);
    ew_peak = vec4(0.0, 0.0, 0.0, peak);
}
