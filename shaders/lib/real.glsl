// The number type of what is computed in either precision: float, or double where LIGHTBENCH_FLOAT64 is defined before the first include.
#ifndef LIGHTBENCH_LIB_REAL
#define LIGHTBENCH_LIB_REAL
#ifdef LIGHTBENCH_FLOAT64
#define real double
#define real3 dvec3
#else
#define real float
#define real3 vec3
#endif
#endif
