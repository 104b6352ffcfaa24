// The laws of attenuation without a lower end: teaching pairs of lib/attenuation.glsl, used nowhere else.
#ifndef LIGHTBENCH_LIB_NAIVE_ATTENUATION
#define LIGHTBENCH_LIB_NAIVE_ATTENUATION
#include "lib/naive/real.glsl"

// Lambert 1760, "Photometria": 1 / (4 pi d^2).
// Breaks: infinite at the light itself, and wherever d^2 is no normal number, below 1e-19; an infinity times a black surface is no number.
float naive_inverse_square(float d) { return float(1.0 / (4.0 * kNaivePi * real(d) * real(d))); }

// Foley, van Dam, Feiner, Hughes 1990, "Computer Graphics", sec. 16.1.2: 1 / (c1 + c2 d), c2 = 1.
// Breaks: infinite at the light itself for c1 = 0.
float naive_linear(float d, float c1) { return float(1.0 / (real(c1) + real(d))); }

#endif
