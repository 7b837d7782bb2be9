// Fog: what is left of light on its way along the ray to the eye. See `ew_fog` in energywave.h, and docs/method.md, section 16.

// Light behind so many optical depths, 4e-18 of itself, does not count.
const float EW_FOG_DEPTH = 40.0;
// So little optical depth is next to none.
const float EW_THIN_FOG = 2e-4;

// The s at which the ray's fog begins.
float ew_fog_begin = 0.0;

// The extinction of the fog along the ray, by s. By height it is speed exp(-(height + rise (s - begin))), which is `extinction` where the
// fog begins.
float ew_fog_extinction = 0.0;
// That of bodies of media comes on top: see media.glsl.
#ifdef EW_MEDIA
float ew_body_extinction = 0.0;
#else
const float ew_body_extinction = 0.0;
#endif
#ifdef EW_FOG_HEIGHT
// The length of an s. In `height` is the extinction at height 0, too.
float ew_fog_speed = 1.0;
float ew_fog_height = 0.0;
// Not 0, and its inverse.
float ew_fog_rise = 1.0;
float ew_fog_inverse_rise = 1.0;
// The s beyond which, towards the thinner fog, a scale of height has next to no optical depth.
float ew_fog_thin_from = 0.0;
#endif

#ifdef EW_FOG_HEIGHT
// That of the fog. Where it is thinner than e^-80 or thicker than e^69, it may as well be as thin or as thick as that.
vec4 ew_fog_extinction_at(const vec4 s)
{
    return ew_fog_speed * exp(-clamp(ew_fog_height + ew_fog_rise * (s - ew_fog_begin), -69.0, 80.0));
}

float ew_fog_extinction_at(const float s)
{
    return ew_fog_extinction_at(vec4(s)).x;
}

// The optical depth from where the fog begins up to s, where its extinction is `at_s`: the integral of an exponential. Where that
// hardly changes it would be a small difference; there it is the way times the series of the mean. Relative error 1e-6 where the fog
// is neither thinner nor thicker than above.
vec4 ew_optical_depth_of(const vec4 s, const vec4 at_s)
{
    vec4 way = s - ew_fog_begin;
    vec4 x = -ew_fog_rise * way;
    vec4 mean = ew_fog_extinction * (1.0 + x * (0.5 + x * (0.16666667 + x * (0.041666667 + x * 0.0083333333))));
    vec4 difference = (ew_fog_extinction - at_s) * ew_fog_inverse_rise;
    return mix(difference, way * mean, lessThan(abs(x), vec4(0.1))) + ew_body_extinction * way;
}

vec4 ew_optical_depth(const vec4 s)
{
    return ew_optical_depth_of(s, ew_fog_extinction_at(s));
}

// The way from s on, `along` the ray (1) or against it (-1), on which there is next to no fog: without end where it thins out, and 0
// where there is some at once.
float ew_way_through_thin_fog(const float s, const float along)
{
    float room = mix(-1.0, 1.0, ew_fog_rise > 0.0) * (s - ew_fog_thin_from);
    float way = mix(max(room, 0.0), mix(0.0, 1e30, room >= 0.0), along * ew_fog_rise > 0.0);
    return min(way, EW_THIN_FOG / max(ew_body_extinction, 1e-30));
}

// How long a panel from s on may be, along the ray or against it, for the transmittance to be next to a polynomial: no longer than `depth`
// of optical depth or two scales of height, unless there is next to no fog in it. The way that takes `depth` is at least
// 2 depth / (2 e + g depth).
float ew_longest_in_fog(const float s, const float along, const float depth)
{
    float growth = -along * ew_fog_rise;
    float way = 2.0 * depth / (2.0 * (ew_fog_extinction_at(s) + ew_body_extinction) + max(growth, 0.0) * depth);
    return max(min(way, 2.0 * abs(ew_fog_inverse_rise)), ew_way_through_thin_fog(s, along));
}
#else
vec4 ew_optical_depth(const vec4 s)
{
    return (ew_fog_extinction + ew_body_extinction) * (s - ew_fog_begin);
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

// Prepares for a ray.
void ew_enter_fog(const ew_segment segment)
{
#ifdef EW_FOG_HEIGHT
    ew_fog_speed = length(segment.direction);
    float rise = dot(ew_fog.height.xyz, segment.direction);
    ew_fog_rise = mix(rise, 1e-30, abs(rise) < 1e-30);
    ew_fog_inverse_rise = 1.0 / ew_fog_rise;
    ew_fog_height = dot(ew_fog.height.xyz, segment.origin) + ew_fog.height.w + ew_fog_begin * rise;
    ew_fog_extinction = ew_fog_extinction_at(ew_fog_begin);
    // Where the extinction is EW_THIN_FOG times the rise.
    float thinner_by = log(abs(ew_fog_rise) / ew_fog_speed) + log(EW_THIN_FOG) + ew_fog_height;
    ew_fog_thin_from = ew_fog_begin - thinner_by * ew_fog_inverse_rise;
#else
    ew_fog_extinction = clamp(ew_fog.density.x * length(segment.direction), 1e-30, 1e30);
#endif
}

// The s at which a ray ends that would end at `end`, because the fog hides all behind it. By height, with the growth g of the extinction
// e along the ray, the way through the depth t is log(1 + x) / g with x = g t / e. It ends somewhat later: that is at most
// t / e / sqrt(1 + x), and log(1.25 x) / g where x > 4.
float ew_end_in_fog(const float end)
{
    float way = EW_FOG_DEPTH / ew_fog_extinction;
#ifdef EW_FOG_HEIGHT
    float x = -ew_fog_rise * way;
    float thickened = ew_fog_thin_from - ew_fog_begin - log(1.25 * EW_FOG_DEPTH / EW_THIN_FOG) * ew_fog_inverse_rise;
    way = mix(mix(1e30, way * inversesqrt(max(1.0 + x, 1e-30)), x > -1.0), thickened, x > 4.0);
#endif
    return min(end, max(ew_fog_begin + way, 0.0));
}
