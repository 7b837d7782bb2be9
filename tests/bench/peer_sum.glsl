// The integral of a source, over the part of the ray that it lights, by samples that peer_place chooses. C puts this file into the
// shader once for each kind, with EW_SOURCE defined as the kind's block. `others` is for the library's own integrator.
float ew_integrate(ew_segment segment, EW_SOURCE source, vec2 chord, float others)
{
#ifdef PEER_EQUIANGULAR
    peer_distribution distribution = peer_distribute(segment, chord, peer_nearest(segment, source));
#else
    peer_distribution distribution = peer_distribute(segment, chord);
#endif
    float jitter = peer_noise();
    int samples = ew_simpson_divisions();
    float stratum = 1.0 / float(samples);
    float sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 place = peer_place(distribution, (float(i) + jitter) * stratum);
        sum += place.y * ew_sample_at(source, segment.origin + place.x * segment.direction, place.x);
    }
    return sum * stratum;
}
