// How the light of a point or spot light thins out with distance. Distance in, factor of Ip out; u = 2^-24.
// Both laws are finite for every d >= 0. The clamps are the lower ends of the domains below: they are far under any distance that a float
// resolves in a scene, and the largest factors (1e18 and 8e28) leave Ip ten decades and more before the product overflows.
// The comparisons are written so that a NaN passes through to the census: max() would turn it into a number.
#ifndef LIGHTBENCH_LIB_ATTENUATION
#define LIGHTBENCH_LIB_ATTENUATION

// Linear law, 1 / (d + d0).
// Foley, van Dam, Feiner, Hughes 1990, "Computer Graphics", sec. 16.1.2 (1 / (c1 + c2 d)): softer than the law of nature, finite at d = 0.
//   d   distance to the light, >= 0        d0  offset, > 0 (0 is taken, and clamped)
// Error: relative 4 u for d + d0 in [1e-18, 1e18] (kernel test AttenuationLinear); beyond 1e38 the factor may be flushed to 0.
float attenuation_linear(float d, float d0) {
    float x = d + d0;
    return 1.0 / (x < 1e-18 ? 1e-18 : x);
}

// Inverse-square law, 1 / (4 pi d^2): the flux of a point spread over a sphere (Lambert 1760, "Photometria").
//   d   distance to the light, >= 0
// Error: relative 4 u for d in [1e-15, 1e15] (kernel test AttenuationInverseSquare); beyond 5e18 the square overflows and the
// factor is 0, the law itself below the smallest normal float.
float attenuation_inverse_square(float d) {
    float x = d < 1e-15 ? 1e-15 : d;
    return 1.0 / (12.566370614 * (x * x));
}

#endif
