// What lights a surface: sources as thin emitters along their shapes. A piece dl of a source, of coefficient c and weight w, has
// the radiant intensity c w dl, evenly in all directions; a point has c r, r its core's radius. A surface at P with the unit normal
// n receives the irradiance
//
//     E(P) = gain * sum over the sources of  color c integral of  w max(0, n . l) k(|C - P|)  |dC|,    l the unit vector from P to C,
//     k(d) = (1 / m - m / L^2)^2,    m = max(r, d),    and 0 beyond the distance L, the light's reach:
//
// the inverse square of the distance, constant in the core, cut so that it comes to 0 with its slope. In ray space, whose unit of
// length the gain of the uniform block makes up for.

struct ew_surface {
    vec3 position;
    vec3 normal;
};

// Gain, in the unit of ray space.
float ew_light_gain()
{
    return ew_frame.light.x;
}

// L.
float ew_light_reach()
{
    return ew_frame.light.y;
}

// k(d), from d^2.
float ew_light_falloff(float distance_squared, float core)
{
    float reach2 = ew_square(ew_light_reach());
    float least = max(distance_squared, core * core);
    return ew_square(max(1.0 - least / reach2, 0.0)) / least;
}

// max(0, n . l) k(d) for the place at `offset` from the surface.
float ew_light_at(ew_surface surface, vec3 offset, float core)
{
    float distance_squared = ew_length_squared(offset);
    return max(dot(surface.normal, offset), 0.0) * inversesqrt(max(distance_squared, 1e-30)) * ew_light_falloff(distance_squared, core);
}
