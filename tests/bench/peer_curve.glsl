float ew_integrate_curve(ew_segment segment, ew_curve_block curve, float others)
{
    return peer_integrate_curve(segment, peer_make_curve(curve));
}
