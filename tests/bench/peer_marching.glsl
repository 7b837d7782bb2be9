// Uniform marching, what game engines ship: equal steps along the ray, jittered by peer_noise.

struct peer_distribution {
    float end;
};

peer_distribution peer_distribute(ew_segment segment)
{
    return peer_distribution(segment.end);
}

// x: s at u in [0, 1), y: 1 / the density of samples there.
vec2 peer_place(peer_distribution distribution, float u)
{
    return distribution.end * vec2(u, 1.0);
}
