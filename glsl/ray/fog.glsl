// Fog: what is left of light on its way along the ray to the eye. See `ew_fog` in energywave.h, and docs/method.md, section 16.

// Light behind so many optical depths, 4e-18 of itself, does not count.
const float EW_FOG_DEPTH = 40.0;
// So little optical depth is next to none.
const float EW_THIN_FOG = 2e-4;

// The s at which the ray's fog begins.
float ew_fog_begin = 0.0;

// The extinction of the fog along the ray, by s. By height it is exp(-(height + rise (s - begin))), which is `extinction` where the fog
// begins.
float ew_fog_extinction = 0.0;
// That of bodies of media comes on top: see media.glsl.
#ifdef EW_MEDIA
float ew_body_extinction = 0.0;
#else
const float ew_body_extinction = 0.0;
#endif
#ifdef EW_FOG_HEIGHT
float ew_fog_height = 0.0;
float ew_fog_rise = 0.0;
// Where the height is more than that below 0, a scale of height has more than next to no optical depth: the logarithm of the ratio.
float ew_fog_thinness = 0.0;
#endif

#ifdef EW_FOG_HEIGHT
// That of the fog. Where it is thinner than e^-80 or thicker than e^69, it may as well be as thin or as thick as that.
vec4 ew_fog_extinction_at(const vec4 s)
{
    return exp(-clamp(ew_fog_height + ew_fog_rise * (s - ew_fog_begin), -69.0, 80.0));
}

float ew_fog_extinction_at(const float s)
{
    return ew_fog_extinction_at(vec4(s)).x;
}

// The optical depth from where the fog begins up to s, where its extinction is `at_s`: the integral of an exponential. Where that
// hardly changes it would be a small difference; there it is the way, times the larger extinction, times the mean of its decay
// from there. Relative error 1e-6 where the fog is neither thinner nor thicker than above.
vec4 ew_optical_depth_of(const vec4 s, const vec4 at_s)
{
    vec4 way = s - ew_fog_begin;
    vec4 x = abs(ew_fog_rise * way);
    vec4 most = max(at_s, ew_fog_extinction);
    vec4 mean = most * (1.0 - x * (0.5 - x * (0.16666667 - x * (0.041666667 - x * 0.0083333333))));
    vec4 difference = (most - min(at_s, ew_fog_extinction)) / max(x, 0.05);
    return way * (mix(difference, mean, lessThan(x, vec4(0.1))) + ew_body_extinction);
}

vec4 ew_optical_depth(const vec4 s)
{
    return ew_optical_depth_of(s, ew_fog_extinction_at(s));
}

float ew_height_in_fog(const float s)
{
    return ew_fog_height + ew_fog_rise * (s - ew_fog_begin);
}

// The way from the fog's begin on in which the fog takes `depth` of optical depth: with the growth g of the extinction e along it,
// log(1 + g depth / e) / g; without end if there is less. e may be too small for a float.
float ew_way_through_fog(const float depth)
{
    float straight = depth / ew_fog_extinction;
    float x = clamp(-ew_fog_rise * straight, -1e37, 1e37);
    float beyond = log(max(1.0 + x, 1e-37)) + max(ew_fog_height - 80.0, 0.0);
    float way = mix(beyond / -ew_fog_rise, straight * (1.0 - x * (0.5 - x * 0.33333333)), abs(x) < 1e-3);
    return mix(way, 1e30, x <= -1.0);
}

// The way from s on, `along` the ray (1) or against it (-1), on which there is next to no fog: without end where it thins out, and 0
// where there is some at once.
float ew_way_through_thin_fog(const float s, const float along)
{
    float growth = -along * ew_fog_rise;
    float room = ew_fog_thinness + ew_height_in_fog(s);
    float way = mix(max(room, 0.0) / growth, mix(0.0, 1e30, room >= 0.0), growth <= 0.0);
    return min(way, EW_THIN_FOG / max(ew_body_extinction, 1e-30));
}

// How long a panel from s on may be, along the ray or against it, for the transmittance to be a polynomial but for EW_FOG_PANEL's
// error: no longer than `depth` of optical depth or two scales of height, unless there is next to no fog in it. The way that takes
// `depth` is at least 2 depth / (2 e + g depth).
float ew_longest_in_fog(const float s, const float along, const float depth)
{
    float growth = -along * ew_fog_rise;
    float way = 2.0 * depth / (2.0 * (ew_fog_extinction_at(s) + ew_body_extinction) + max(growth, 0.0) * depth);
    return max(min(way, 2.0 / max(abs(growth), 1e-30)), ew_way_through_thin_fog(s, along));
}
#else
vec4 ew_optical_depth(const vec4 s)
{
    return (ew_fog_extinction + ew_body_extinction) * (s - ew_fog_begin);
}

float ew_way_through_fog(const float depth)
{
    return depth / ew_fog_extinction;
}

float ew_way_through_thin_fog(const float s, const float along)
{
    return EW_THIN_FOG / (ew_fog_extinction + ew_body_extinction);
}

float ew_longest_in_fog(const float s, const float along, const float depth)
{
    return depth / (ew_fog_extinction + ew_body_extinction);
}
#endif

vec4 ew_transmittance_of(const vec4 optical_depth)
{
    return exp2(-1.44269504 * clamp(optical_depth, 0.0, 100.0));
}

// The share of the light at s that reaches the place where the fog begins.
vec4 ew_transmittance(const vec4 s)
{
    return ew_transmittance_of(ew_optical_depth(s));
}

vec3 ew_transmittance(const vec3 s)
{
    return ew_transmittance(vec4(s, ew_fog_begin)).xyz;
}

float ew_transmittance(const float s)
{
    return ew_transmittance(vec4(s)).x;
}

// Of a place in the midst of a panel: x: the optical depth there, y: the fog's extinction.
vec2 ew_fog_at(const float s)
{
#ifdef EW_FOG_HEIGHT
    float extinction = ew_fog_extinction_at(s);
    return vec2(ew_optical_depth_of(vec4(s), vec4(extinction)).x, extinction);
#else
    return vec2(ew_optical_depth(vec4(s)).x, ew_fog_extinction);
#endif
}

// The share of the light at places of the panel, `y` before or behind its middle, where `fog` is: the series of the mean of the
// extinction over y in scales of height, at most one. Beyond, there is next to no fog.
vec3 ew_transmittance_in_panel(const vec2 fog, const vec3 y)
{
    vec3 depth = fog.y * y;
#ifdef EW_FOG_HEIGHT
    vec3 x = clamp(-ew_fog_rise * y, -1.0, 1.0);
    depth *= 1.0 + x * (0.5 + x * (0.16666667 + x * (0.041666667 + x * (0.0083333333 + x * (0.0013888889 + x * 0.00019841270)))));
#endif
    return exp2(-1.44269504 * clamp(fog.x + depth + ew_body_extinction * y, 0.0, 100.0));
}

// Prepares for a ray.
void ew_enter_fog(const ew_segment segment)
{
    float density = clamp(ew_fog.density.x * length(segment.direction), 1e-30, 1e30);
#ifdef EW_FOG_HEIGHT
    ew_fog_rise = dot(ew_fog.height.xyz, segment.direction);
    ew_fog_height = dot(ew_fog.height.xyz, segment.origin) + ew_fog.height.w + ew_fog_begin * ew_fog_rise - log(density);
    ew_fog_extinction = ew_fog_extinction_at(ew_fog_begin);
    ew_fog_thinness = log(EW_THIN_FOG * max(abs(ew_fog_rise), 1e-30));
#else
    ew_fog_extinction = density;
#endif
}

// The s at which a ray ends that would end at `end`, because the fog hides all behind it.
float ew_end_in_fog(const float end)
{
    return min(end, max(ew_fog_begin + ew_way_through_fog(EW_FOG_DEPTH), 0.0));
}
