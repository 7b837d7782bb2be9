float ew_integrate_curve(ew_segment segment, ew_curve_block curve)
{
    return 0.0;
}
