// The number type of the naive formulas: float, or double where NAIVE_FLOAT64 is defined before the first include.
#ifndef LIGHTBENCH_LIB_NAIVE_REAL
#define LIGHTBENCH_LIB_NAIVE_REAL
#ifdef NAIVE_FLOAT64
#define real double
#define real3 dvec3
const double kNaivePi = 3.14159265358979323846lf;
#else
#define real float
#define real3 vec3
const float kNaivePi = 3.14159265;
#endif
#endif
