// The number type of the naive formulas, and the constant that they need in it.
#ifndef LIGHTBENCH_LIB_NAIVE_REAL
#define LIGHTBENCH_LIB_NAIVE_REAL
#include "lib/real.glsl"
#ifdef LIGHTBENCH_FLOAT64
const double kNaivePi = 3.14159265358979323846lf;
#else
const float kNaivePi = 3.14159265;
#endif
#endif
