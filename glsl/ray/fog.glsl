// Fog: what is left of light on its way along the ray to the eye. See `ew_fog` in energywave.h, and docs/method.md, section 15.

// Light behind so many optical depths, 4e-18 of itself, does not count.
const float EW_FOG_DEPTH = 40.0;

// The s at which the ray's fog begins.
float ew_fog_begin = 0.0;

// The extinction along the ray, by s: density exp(-(height + rise (s - begin))). Without heights it is the density.
float ew_fog_density = 0.0;
#ifdef EW_FOG_HEIGHT
float ew_fog_height = 0.0;
float ew_fog_rise = 0.0;
#endif

#ifdef EW_FOG_HEIGHT
// (1 - exp(-x)) / x for x >= 0. Relative error 1e-6.
vec4 ew_mean_of_decay(vec4 x)
{
    vec4 series = 1.0 - x * (0.5 - x * (0.16666667 - x * (0.041666667 - x * 0.0083333333)));
    return mix((1.0 - exp(-x)) / max(x, 1e-3), series, lessThan(x, vec4(0.1)));
}

float ew_extinction(float s)
{
    float height = ew_fog_height + ew_fog_rise * (s - ew_fog_begin);
    return min(ew_fog_density * exp(-clamp(height, -80.0, 80.0)), 1e30);
}

// The optical depth from where the fog begins up to s: the way, times the extinction at its lowest place, times the mean of its decay
// from there up. A sum or product of positive terms.
vec4 ew_optical_depth(vec4 s)
{
    vec4 way = s - ew_fog_begin;
    vec4 rise = ew_fog_rise * way;
    vec4 lowest = clamp(ew_fog_height + min(rise, 0.0), -80.0, 80.0);
    return min(ew_fog_density * exp(-lowest), 1e30) * way * ew_mean_of_decay(abs(rise));
}

// The way from s on, `along` the ray (1) or against it (-1), that takes `depth` of optical depth: the inverse of
// extinction (1 - exp(-rise way)) / rise.
float ew_way_through_fog(float s, float along, float depth)
{
    float straight = depth / max(ew_extinction(s), 1e-30);
    float x = min(along * ew_fog_rise * straight, 1e15);
    float way = straight * -log(max(1.0 - x, 1e-37)) / mix(x, 1.0, abs(x) < 1e-3);
    way = mix(way, straight * (1.0 + x * (0.5 + x * 0.33333333)), abs(x) < 1e-3);
    return mix(way, 1e30, x >= 1.0);
}

// How long a panel from s on may be, along the ray or against it, for the transmittance to be a polynomial but for EW_FOG_PANEL's
// error: no longer than so many optical depths or scales of height, unless there is next to no fog in it.
float ew_longest_in_fog(float s, float along, float depth)
{
    float way = min(ew_way_through_fog(s, along, depth), 2.0 / max(abs(ew_fog_rise), 1e-30));
    return max(way, ew_way_through_fog(s, along, 1e-3 * depth));
}
#else
vec4 ew_optical_depth(vec4 s)
{
    return ew_fog_density * (s - ew_fog_begin);
}

float ew_way_through_fog(float s, float along, float depth)
{
    return depth / ew_fog_density;
}

float ew_longest_in_fog(float s, float along, float depth)
{
    return depth / ew_fog_density;
}
#endif

// The share of the light at s that reaches the place where the fog begins.
vec4 ew_transmittance(vec4 s)
{
    return exp2(-1.44269504 * min(ew_optical_depth(s), 100.0));
}

vec3 ew_transmittance(vec3 s)
{
    return ew_transmittance(vec4(s, ew_fog_begin)).xyz;
}

float ew_transmittance(float s)
{
    return ew_transmittance(vec4(s)).x;
}

// Prepares for a ray, and ends it where the fog hides all.
void ew_enter_fog(inout ew_segment segment)
{
    ew_fog_density = min(max(ew_fog.density.x * length(segment.direction), 1e-30), 1e30);
#ifdef EW_FOG_HEIGHT
    ew_fog_rise = dot(ew_fog.height.xyz, segment.direction);
    ew_fog_height = dot(ew_fog.height.xyz, segment.origin) + ew_fog.height.w + ew_fog_begin * ew_fog_rise;
#endif
    segment.end = min(segment.end, max(ew_fog_begin + ew_way_through_fog(ew_fog_begin, 1.0, EW_FOG_DEPTH), 0.0));
}
