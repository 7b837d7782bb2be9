// The sum over all sources.

// B_i is cut here, far above what any target shows, so that sums and products of it stay finite.
const float EW_MAX_LUMINANCE = 1e30;

#ifdef EW_SHARPNESS
// b g(B / b) with g(x) = x^sharpness for x <= 1 and its straight continuation, 1 + sharpness (x - 1), beyond.
float ew_sharpen(const float luminance, const float brightness, const float sharpness)
{
    float x = luminance / brightness;
    return brightness * mix(1.0 + sharpness * (x - 1.0), pow(x, sharpness), x <= 1.0);
}
#endif

// Adds the light of one source to the sum. `color` and `glow` are its block's: color.w is its coefficient.
void ew_add(const float integral, const vec4 color, const vec4 glow, inout vec4 sum)
{
    float luminance = clamp(color.w * integral, 0.0, EW_MAX_LUMINANCE);
#ifdef EW_SHARPNESS
    if (glow.z > 1.0) luminance = min(ew_sharpen(luminance, glow.w, glow.z), EW_MAX_LUMINANCE);
#endif
    sum += vec4(luminance * color.rgb, luminance);
}

// What the other sources that came before add to an integral, in its unit: over the coefficient, which may be 0. It is so
// bounded that the quotient is finite.
float ew_others(const vec4 sum, const vec4 color)
{
    return min(sum.a, 1e6) / max(color.w, 1e-30);
}

// Adds all sources of a kind: `source` is its block, `read` what reads one.
#ifdef EW_WORLD
#define EW_SPEED length(segment.direction) *
#else
#define EW_SPEED
#endif
#define EW_INTEGRAL(source, part) EW_SPEED ew_integrate(segment, source, part, ew_others(sum, source.color))
#ifdef EW_MEDIA
// Leg by leg of the ray: see media.glsl. The next one is looked for before the loop ends, so that a software rasteriser, which computes
// what it need not, does not go through it for nothing.
#define EW_ADD_LEG(source) vec2 part = ew_enter_leg(chord, leg); light += ew_leg_share * EW_INTEGRAL(source, part); leg = ew_next_leg(chord, leg + 1);
#define EW_ADD_LEGS(source) int leg = ew_next_leg(chord, 0); do { EW_ADD_LEG(source) } while (leg < ew_leg_count);
#define EW_ADD_SOURCE(source) float light = 0.0; EW_ADD_LEGS(source) ew_add(light, source.color, source.glow, sum)
#else
#define EW_ADD_SOURCE(source) ew_add(EW_INTEGRAL(source, chord), source.color, source.glow, sum)
#endif
#ifdef EW_FIELD
#define EW_ADD(block, read, step) block source = read(i); sum.a += ew_field_of(segment, source); i += step(i);
#define EW_ADD_ALL(block, read, step) if (i < end) { do { EW_ADD(block, read, step) } while (i < end); }
#elif defined(EW_REACH)
// Sources that the ray misses are passed over in a loop of their own: where a group of pixels has few, a software rasteriser goes
// through the expensive body as often as the pixel of the group that has most. A pixel that has left that loop while others of its
// group have not may see its values computed once more (llvmpipe does so); so the search stays where it is once it has found one.
#define EW_LIT(source) min(ew_chord(segment, source), max(ew_last_lit(source.glow), 0.0))
#define EW_CHORD(source) mix(whole, EW_LIT(source), bvec2(ew_has_reach(source.glow)))
#ifdef EW_SOFTWARE
// It is kept from within the loop, where a software rasteriser gathers it component by component.
#define EW_TRY(block, read, step) source = read(i); chord = EW_CHORD(source); hit = hit || chord.x < chord.y; i += int(!hit) * step(i);
#define EW_FIND(block, read, step) block source; bool hit = false; do { EW_TRY(block, read, step) } while (!hit && i < end);
#define EW_HIT(block, read, step) EW_ADD_SOURCE(source); i += step(i);
#else
// The source is read anew: SwiftShader loses one that is kept from within the loop.
#define EW_TRY(block, read, step) block tried = read(i); chord = EW_CHORD(tried); hit = hit || chord.x < chord.y; i += int(!hit) * step(i);
#define EW_FIND(block, read, step) bool hit = false; do { EW_TRY(block, read, step) } while (!hit && i < end);
#define EW_HIT(block, read, step) block source = read(i); chord = EW_CHORD(source); EW_ADD_SOURCE(source); i += step(i);
#endif
#define EW_ADD(block, read, step) EW_FIND(block, read, step) if (hit) { EW_HIT(block, read, step) }
#define EW_ADD_ALL(block, read, step) if (i < end) { do { EW_ADD(block, read, step) } while (i < end); }
#else
#define EW_ADD(block, read, step) block source = read(i); EW_ADD_SOURCE(source); i += step(i);
#define EW_ADD_ALL(block, read, step) if (i < end) { do { EW_ADD(block, read, step) } while (i < end); }
#endif
#define EW_ADD_KIND(block, read, step, first, last, count) EW_EACH(first, last, count, EW_ADD_ALL(block, read, step))

// The light of all sources along a segment: sum B_i color_i, and sum B_i as the fourth component. C defines EW_ADD_KINDS: one
// EW_ADD_KIND for each kind that the shader knows.
vec4 ew_integrate_all(ew_segment segment)
{
    vec4 sum = vec4(0.0);
#ifdef EW_FOG
    ew_enter_fog(segment);
    segment.end = ew_end_in_fog(segment.end);
#endif
#ifdef EW_MEDIA
    ew_enter_media(segment);
    segment.end = max(ew_legs[ew_leg_count].x, 0.0);
#endif
    vec2 whole = vec2(0.0, segment.end);
    vec2 chord = whole;
    EW_ADD_KINDS
#ifdef EW_MEDIA
    ew_fog_begin = ew_legs[0].x;
#ifdef EW_FIELD
    if (ew_is_near_edge(segment)) sum.a = EW_UNRESOLVED;
#endif
#endif
    return sum;
}
