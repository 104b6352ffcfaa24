// (o, d, m, after) -> t: naive, in float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 8
#define LIGHTBENCH_FLOAT64
#include "numerics/pair.glsl"
#include "lib/naive/torus.glsl"

float call() { return naive_torus(argument3(0), argument3(3), argument(6), argument(7)); }
