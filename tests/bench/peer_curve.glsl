float ew_integrate(ew_segment segment, ew_curve_block curve, float others)
{
    return peer_integrate_curve(segment, peer_make_curve(curve), others);
}
