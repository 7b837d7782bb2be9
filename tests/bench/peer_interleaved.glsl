// Interleaved sampling (Keller and Heidrich 2001): within each square of 4 x 4 pixels all offsets differ, in the order of Bayer's
// matrix, so that a filter over such a square has sixteen times the samples.
float peer_noise()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    int coarse = (place.x ^ place.y) & 1;
    int fine = ((place.x ^ place.y) >> 1) & 1;
    int index = coarse << 3 | (place.y & 1) << 2 | fine << 1 | ((place.y >> 1) & 1);
    return (float(index) + 0.5) / 16.0;
}
