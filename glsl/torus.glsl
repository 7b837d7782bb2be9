float ew_integrate_torus(ew_segment segment, ew_torus_block torus)
{
    return 0.0;
}
