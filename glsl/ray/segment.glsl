// What sources are integrated over: a segment of a ray, and the arithmetic that all of them need.

// The ray is L(s) = origin + s direction in ray space (see layout.glsl), with s in [0, end]. Light at s counts 1 / (s +
// beta)^2, the decay of equation (21) with alpha = 1; alpha is part of the sources' coefficients.
struct ew_segment {
    vec3 origin;
    vec3 direction; // |direction| >= 1
    float end;      // in [0, 1]
};

// Guards work that only some pixels need. A software rasteriser does such work for every pixel and masks the result, so there
// the branch would be a cost without a gain.
#ifdef EW_SOFTWARE
#define EW_IS_NEEDED(condition) true
#else
#define EW_IS_NEEDED(condition) (condition)
#endif

// How many times the distance to a source was evaluated.
int ew_evaluation_count = 0;

float ew_square(const float x)
{
    return x * x;
}

float ew_length_squared(const vec3 v)
{
    return dot(v, v);
}
