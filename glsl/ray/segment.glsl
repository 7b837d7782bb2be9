// The one thing that sources are integrated over: a piece of a ray, L(s) = origin + s direction with s in [0, end], seen with
// the decay 1 / (s + beta)^2 of (21), alpha = 1. (alpha is part of the sources' coefficients.)

struct ew_segment {
    vec3 origin;
    vec3 direction; // |direction| >= 1
    float end;      // in [0, 1]
};

// Whether to do what only some pixels need. A software rasteriser does it for all in any case, and then masks it out.
#ifdef EW_SOFTWARE
#define EW_IS_NEEDED(condition) true
#else
#define EW_IS_NEEDED(condition) (condition)
#endif

// How many times the distance to a source was evaluated.
int ew_evaluation_count = 0;

float ew_square(float x)
{
    return x * x;
}

float ew_length_squared(vec3 v)
{
    return dot(v, v);
}
