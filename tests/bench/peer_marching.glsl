// Uniform marching, what game engines ship: equal steps along the part of the ray that a source lights, jittered by peer_noise.

struct peer_distribution {
    float start;
    float end;
};

peer_distribution peer_distribute(ew_segment segment, vec2 chord)
{
    return peer_distribution(chord.x, chord.y);
}

// x: s at u in [0, 1), y: 1 / the density of samples there.
vec2 peer_place(peer_distribution distribution, float u)
{
    return vec2(mix(distribution.start, distribution.end, u), distribution.end - distribution.start);
}
