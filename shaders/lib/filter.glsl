// Weights of samples about the middle of a pixel. Distances in pixels in, weights out, to be divided by their sum (AA-4); u = 2^-24.
#ifndef LIGHTBENCH_LIB_FILTER
#define LIGHTBENCH_LIB_FILTER
#include "lib/power.glsl"

// Gaussian bell lowered so that it ends at 0 on its radius, without a step. Pharr, Jakob, Humphreys 2016, "Physically based rendering" 3rd
// ed., sec. 7.8.1, has one a axis; this one is round: no direction of the picture is blurred more than another.
//   offset   of the sample from the middle of the pixel
//   radius   > 0
//   sigma    standard deviation, in [1e-3, 1e3] of the radius
//   returns exp(-r^2/(2 sigma^2)) - exp(-radius^2/(2 sigma^2)), r = |offset|; never below 0, 0 from radius on
// Error: absolute 4 u (kernel test FilterGaussian).
float filter_gaussian(vec2 offset, float radius, float sigma) {
    float r2 = dot(offset, offset), end2 = radius * radius, width = 2.0 * (sigma * sigma);
    float weight = exp_negative(-r2 / width) - exp_negative(-end2 / width);
    return r2 >= end2 || weight <= 0.0 ? 0.0 : weight;
}

#endif
