// The header is C++ too: its functions link, and its defaults are an initialiser from C++20 on.
#include <energywave.h>

#include <cstring>

int main()
{
#if __cplusplus >= 202002L
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    if (frame.exposure != 1) return 1;
#endif
    double weights[2];
    ew_fill_pulse_weights(25, weights, 2);
    return weights[0] == 1 && std::strlen(ew_result_text(EW_OK)) > 0 ? 0 : 1;
}
