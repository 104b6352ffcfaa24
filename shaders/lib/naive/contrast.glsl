// The contrast of adaptive sampling as its quotient: a teaching pair of is_rough in raytrace/lattice_split.comp, used nowhere else.
#ifndef LIGHTBENCH_LIB_NAIVE_CONTRAST
#define LIGHTBENCH_LIB_NAIVE_CONTRAST
#include "lib/naive/real.glsl"

// Mitchell 1987, "Generating antialiased images at low sampling densities", sec. 3: (Imax - Imin) / (Imax + Imin) above a threshold.
// Breaks: 0/0 in a black cell is no number, and whatever compares with it is a matter of the compiler; the quotient rounds once more.
float naive_contrast(float high, float low, float threshold) {
    return (real(high) - real(low)) / (real(high) + real(low)) > real(threshold) ? 1.0 : 0.0;
}

#endif
