// Facets of rough mirrors and frosted glass. A normal and two random numbers in, the normal of a facet out; u = 2^-24.
#ifndef LIGHTBENCH_LIB_SCATTER
#define LIGHTBENCH_LIB_SCATTER
#include "lib/bump.glsl"
#include "lib/noise.glsl"
#include "lib/power.glsl"

// A facet of a surface whose slopes are Gaussian along each direction, tan^2 of the angle to n exponential with mean slope^2.
// Beckmann, Spizzichino 1963, "The scattering of electromagnetic waves from rough surfaces", ch. 5; Walter, Marschner, Li, Torrance 2007,
// "Microfacet models for refraction through rough surfaces", eq. 28 and 29. The area of the facets seen along n is what is sampled:
// D(n.h) (n.h).
//   n        unit to 6 u
//   slope    rms slope m, in [0, 1e3]; 0 gives n itself
//   xi       two uniform numbers in [0, 1)
//   returns a unit vector with n.h > 0
// Error: | |h| - 1 | <= 6 u, absolute 8 u (kernel test ScatteredNormal).
vec3 scattered_normal(vec3 n, float slope, vec2 xi) {
    float tangent = slope * sqrt(-log_one_minus(xi.x));
    vec2 azimuth = sine_cosine(xi.y);
    vec3 tt = any_tangent(n), bb = cross(n, tt);
    vec3 h = fast_normalize(n + tangent * (azimuth.y * tt + azimuth.x * bb));
    return slope == 0.0 ? n : h;
}

#endif
