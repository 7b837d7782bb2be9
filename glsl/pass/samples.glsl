// The samples of a pixel that a pass shades. Rasterisers shade a surface once a pixel, and know its depth at every sample; so does light
// over it. Where a pixel sees several surfaces, each of them has a pass, which writes only the samples that see it (EW_SAMPLE_MASK).
// Contexts that do not know gl_SampleMask draw a pass for each sample.

// What the pass makes of ew_samples: see sample_passes.h. From 0 on it shades one of its pixel's surfaces, in the order of their first
// samples.
uniform int ew_surface_rank;
const int EW_EVERY_SAMPLE = -1;
const int EW_ONE_SURFACE = -2;

const int EW_MAX_SAMPLES = 32;

// From `first` up to but not including `end`.
struct ew_shaded_samples {
    int first;
    int end;
    float depth; // of all of a surface: the mean, which is a plane's depth at the pixel's centre
};

// The loop tests at its end: see each.glsl.
ew_shaded_samples ew_chosen_samples(const ivec2 place)
{
    if (ew_surface_rank == EW_EVERY_SAMPLE) return ew_shaded_samples(ew_samples.x, ew_samples.y, 0.0);
    float sum = 0.0;
    int i = ew_samples.x;
    do {
        sum += ew_window_depth(place, i);
    } while (++i < min(ew_samples.y, EW_MAX_SAMPLES));
    return ew_shaded_samples(ew_samples.x, ew_samples.x + 1, sum / float(ew_samples.y - ew_samples.x));
}

#ifdef EW_SAMPLE_MASK
// How much window depth changes from a pixel to the next along its surface. On a plane that is the same on both sides. At a silhouette the
// smaller difference is the surface's own, and beside what is thinner than a pixel the two cancel each other. At the border of what is drawn
// there is one.
float ew_depth_slope(const ivec2 place, const ivec2 step, const float depth)
{
    ivec2 first = ew_grid.viewport.xy;
    ivec2 last = first + ew_grid.viewport.zw - 1;
    ivec2 before = max(place - step, first);
    ivec2 after = min(place + step, last);
    float fall = depth - ew_window_depth(before, 0);
    float rise = ew_window_depth(after, 0) - depth;
    if (before == place) fall = rise;
    if (after == place) rise = fall;
    return min(0.5 * abs(fall + rise), 2.0 * min(abs(fall), abs(rise)));
}

// How far apart the depths of samples of one surface may be. Samples are less than a pixel apart, and depths are rounded to 24 bits.
float ew_depth_tolerance(const ivec2 place)
{
    const float rounding = 1.0 / 4194304.0;
    float depth = ew_window_depth(place, 0);
    return ew_depth_slope(place, ivec2(1, 0), depth) + ew_depth_slope(place, ivec2(0, 1), depth) + rounding * abs(depth);
}

// Takes from the samples `left`, as bits, those that see the surface of the first, and returns them.
int ew_take_surface(const ivec2 place, const float tolerance, inout int left)
{
    int first = findLSB(left);
    float depth = ew_window_depth(place, first);
    int surface = 1 << first;
    for (int i = first + 1; i < min(ew_samples.y, EW_MAX_SAMPLES); ++i)
        if (abs(ew_window_depth(place, i) - depth) <= tolerance) surface |= 1 << i;
    surface &= left;
    left &= ~surface;
    return surface;
}

float ew_mean_depth(const ivec2 place, const int samples)
{
    float sum = 0.0;
    for (int i = 0; i < min(ew_samples.y, EW_MAX_SAMPLES); ++i)
        if ((samples >> i & 1) != 0) sum += ew_window_depth(place, i);
    return sum / float(bitCount(samples));
}

// Discards pixels that have no such surface.
ew_shaded_samples ew_samples_to_shade(const ivec2 place)
{
    gl_SampleMask[0] = -1;
    if (ew_surface_rank < 0) return ew_chosen_samples(place);
    float tolerance = ew_depth_tolerance(place);
    int left = ew_samples.y < EW_MAX_SAMPLES ? (1 << ew_samples.y) - 1 : -1;
    int surface = 0;
    int rank = -1;
    do {
        surface = ew_take_surface(place, tolerance, left);
        ++rank;
    } while (left != 0 && rank < min(ew_surface_rank, EW_MAX_SAMPLES));
    if (rank < ew_surface_rank) discard;
    gl_SampleMask[0] = surface;
    int first = findLSB(surface);
    return ew_shaded_samples(first, first + 1, ew_mean_depth(place, surface));
}
#else
ew_shaded_samples ew_samples_to_shade(const ivec2 place)
{
    return ew_chosen_samples(place);
}
#endif

// The depth up to which sample i is shaded.
float ew_depth_to_shade(const ew_shaded_samples shaded, const ivec2 place, const int i)
{
    return ew_surface_rank == EW_EVERY_SAMPLE ? ew_window_depth(place, i) : shaded.depth;
}
