/*
 * The falloffs that billboards and ribbons are painted with, each fitted to the field of one source.
 */
#ifndef PEER_PROFILE_H
#define PEER_PROFILE_H

#include "source_kinds.h"

/* The texels of a falloff. Texel i is centred at the distance ((i + 0.5) / PROFILE_TEXELS)^2 of the reach, so that the core has
 * as many as the rest. */
enum { PROFILE_TEXELS = 64 };

/* What the luminance is b away from the middle of a long straight beam that is seen from the side, or of an orb: relative to
 * that in the middle. In closed form: with h = sqrt(R^2 - b^2) and x = sqrt(r^2 - b^2), the integral of 1 / max(r, d) - 1 / R
 * along the ray is 2 (x / r + ln((h + R) / (x + max(r, b))) - h / R). */
double profile_across(const source_light *light, double b);

/* The falloff of a ribbon or of an orb's only billboard: that luminance itself. */
void profile_of_ribbon(const source_light *light, float texels[PROFILE_TEXELS]);

/* The falloffs of billboards that stand `spacing` apart along a beam and add up, and of one more at each end of it, where there
 * is as much light all around. Each is the one, neither negative nor rising, with which the sum is nearest to the luminance of
 * a beam that is seen from the side, by least squares of the error relative to max(luminance, 3 % of the middle's): first that
 * along the beam, over places across it and from one billboard to the next, then that of the ends, over places around one. */
void profiles_of_billboards(const source_light *light, double spacing, float along[PROFILE_TEXELS], float end[PROFILE_TEXELS]);

#endif
