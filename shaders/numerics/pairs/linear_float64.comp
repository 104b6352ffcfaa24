// (d, d0) -> factor: naive, in float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 2
#define LIGHTBENCH_FLOAT64
#include "numerics/pair.glsl"
#include "lib/naive/attenuation.glsl"

float call() { return naive_linear(argument(0), argument(1)); }
