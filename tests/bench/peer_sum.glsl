// The sum over the samples of a source: PEER_INTEGRATE for one of the type PEER_SOURCE. Compiled once for each kind of source.
float PEER_INTEGRATE(ew_segment segment, PEER_SOURCE source, float others)
{
#ifdef PEER_EQUIANGULAR
    peer_distribution distribution = peer_distribute(segment, peer_nearest(segment, source));
#else
    peer_distribution distribution = peer_distribute(segment);
#endif
    float jitter = peer_noise();
    float stratum = 1.0 / float(ew_frame.simpson.x);
    float sum = 0.0;
    for (int i = 0; i < ew_frame.simpson.x; ++i) {
        vec2 place = peer_place(distribution, (float(i) + jitter) * stratum);
        sum += place.y * peer_value(segment, source, place.x);
    }
    return sum * stratum;
}
