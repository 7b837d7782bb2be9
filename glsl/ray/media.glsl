// Media: bodies of constant extinction, which divide a ray into legs between which it changes. See `ew_medium` in energywave.h,
// and docs/method.md, section 16.

// A ray has at most so many legs.
const int EW_MAX_LEGS = 2 * EW_MEDIUM_ROOM + 1;

// The bodies that the ray meets: where, by s; and their extinction, by s.
int ew_met_count = 0;
int ew_met_bodies[EW_MEDIUM_ROOM];
vec2 ew_met_chords[EW_MEDIUM_ROOM];
float ew_met_extinctions[EW_MEDIUM_ROOM];

// The legs of the ray, from where its fog begins. x: the s where a leg begins, up to the next one's; y: the extinction of the bodies
// there, by s; z: the optical depth up to there, of fog and bodies. The first one behind all legs says where the ray ends.
int ew_leg_count = 0;
vec3 ew_legs[EW_MAX_LEGS + 2];

// The share of the light at the begin of the leg that was entered which reaches the begin of the first one.
float ew_leg_share = 1.0;

#ifdef EW_FOG_HEIGHT
// What the fog's height is relative to: the s where the first leg begins, and the height there.
vec2 ew_first_height = vec2(0.0);
#endif

// A ray in the space of a body: place + s step.
struct ew_body_ray {
    vec3 place;
    vec3 step;
};

ew_body_ray ew_bring_to_body(const ew_segment segment, const ew_medium_block body)
{
    vec4 origin = vec4(segment.origin, 1.0);
    return ew_body_ray(vec3(dot(body.row_x, origin), dot(body.row_y, origin), dot(body.row_z, origin)),
                       vec3(dot(body.row_x.xyz, segment.direction), dot(body.row_y.xyz, segment.direction),
                            dot(body.row_z.xyz, segment.direction)));
}

// Where it meets the planes of a cube's three slabs. Along a slab, a ray is in it all the way, or not at all.
struct ew_slabs {
    vec3 near;
    vec3 far;
    vec3 speed; // across them, not 0
};

ew_slabs ew_meet_slabs(const ew_body_ray ray)
{
    vec3 speed = mix(ray.step, vec3(1e-30), lessThan(abs(ray.step), vec3(1e-30)));
    vec3 first = (-1.0 - ray.place) / speed;
    vec3 second = (1.0 - ray.place) / speed;
    return ew_slabs(min(first, second), max(first, second), abs(speed));
}

// Where a line is in a body, from x to y, and z, how long that is, which the difference of x and y would not tell of a thin pane far away.
// Of a ball it is a chord, of a cube what three slabs have in common. Empty, x >= y, where the line passes by.
vec3 ew_chord_of_body(const ew_segment segment, const int i)
{
    ew_body_ray ray = ew_bring_to_body(segment, ew_media[i]);
    if (i < ew_fog.bodies.y) {
        ew_slabs slabs = ew_meet_slabs(ray);
        vec2 chord = vec2(max(max(slabs.near.x, slabs.near.y), slabs.near.z), min(min(slabs.far.x, slabs.far.y), slabs.far.z));
        vec3 width = 2.0 / slabs.speed;
        float way = chord.y - chord.x;
        for (int slab = 0; slab < 3; ++slab)
            way = mix(way, width[slab], slabs.near[slab] == chord.x && slabs.far[slab] == chord.y);
        return vec3(chord, way);
    }
    float k = max(ew_length_squared(ray.step), 1e-30);
    float middle = -dot(ray.place, ray.step) / k;
    float half_chord = sqrt(max(1.0 - ew_length_squared(ray.place + middle * ray.step), 0.0) / k);
    return vec3(middle - half_chord, middle + half_chord, 2.0 * half_chord);
}

// Takes a body into the list of those that the ray meets between `begin` and its end, if it does. `speed`: the length of an s.
void ew_meet_body(const ew_segment segment, const float begin, const float speed, const int i)
{
    vec3 whole = ew_chord_of_body(segment, i);
    // The thinnest pane that s can tell is that thin.
    float far = max(whole.y, whole.x + 2e-7 * abs(whole.x));
    vec2 chord = clamp(vec2(whole.x, far), begin, segment.end);
    if (whole.x <= whole.y && whole.z > 0.0 && chord.x < chord.y) {
        ew_met_bodies[ew_met_count] = i;
        ew_met_chords[ew_met_count] = chord;
        ew_met_extinctions[ew_met_count] = speed * ew_media[i].light.w * (whole.z / (far - whole.x));
        ew_met_count += 1;
    }
}

// What dims the light from s on, up to where that changes.
void ew_enter_air(const float s, const float extinction)
{
    ew_fog_begin = s;
    ew_body_extinction = extinction;
#ifdef EW_FOG_HEIGHT
    ew_fog_height = ew_first_height.y + ew_fog_rise * (s - ew_first_height.x);
    ew_fog_extinction = ew_fog_extinction_at(s);
#endif
}

// Divides a ray into legs, after ew_enter_fog; what EW_FOG_DEPTH hides has none. Enters the last of them.
void ew_enter_media(const ew_segment segment)
{
    float speed = length(segment.direction);
    float s = ew_fog_begin;
    float depth = 0.0;
#ifdef EW_FOG_HEIGHT
    ew_first_height = vec2(ew_fog_begin, ew_fog_height);
#endif
    ew_met_count = 0;
    for (int i = 0; i < EW_MEDIUM_ROOM && i < ew_fog.bodies.x; ++i)
        ew_meet_body(segment, s, speed, i);
    ew_leg_count = 0;
    do {
        float next = segment.end;
        float extinction = 0.0;
        for (int i = 0; i < ew_met_count; ++i) {
            vec2 chord = ew_met_chords[i];
            next = mix(next, min(next, mix(chord.y, chord.x, chord.x > s)), chord.y > s);
            extinction += mix(0.0, ew_met_extinctions[i], chord.x <= s && s < chord.y);
        }
        // In a body, too, the light of what is hidden does not count.
        next = min(next, s + (EW_FOG_DEPTH - depth) / max(extinction, 1e-30));
        ew_legs[ew_leg_count] = vec3(s, extinction, depth);
        ew_enter_air(s, extinction);
        ew_leg_share = ew_transmittance_of(vec4(depth)).x;
        depth += max(ew_optical_depth(vec4(next)).x, 0.0);
        ew_leg_count += 1;
        s = next;
    } while (s < segment.end && depth < EW_FOG_DEPTH && ew_leg_count < EW_MAX_LEGS);
    ew_legs[ew_leg_count] = vec3(s, 0.0, depth);
    ew_legs[ew_leg_count + 1] = ew_legs[ew_leg_count];
}

// The first leg from `leg` on that has a part of `chord`; their count if there is none.
int ew_next_leg(const vec2 chord, int leg)
{
    bool is_empty;
    do {
        is_empty = max(chord.x, ew_legs[leg].x) >= min(chord.y, ew_legs[leg + 1].x);
        leg += is_empty ? 1 : 0;
    } while (is_empty && leg < ew_leg_count);
    return leg;
}

// Enters a leg, and returns the part of `chord` that is on it.
vec2 ew_enter_leg(const vec2 chord, const int leg)
{
    ew_enter_air(ew_legs[leg].x, ew_legs[leg].y);
    ew_leg_share = ew_transmittance_of(vec4(ew_legs[leg].z)).x;
    return vec2(max(chord.x, ew_legs[leg].x), min(chord.y, ew_legs[leg + 1].x));
}
