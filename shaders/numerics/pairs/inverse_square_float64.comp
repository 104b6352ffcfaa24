// (d) -> factor: naive, in float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 1
#define LIGHTBENCH_FLOAT64
#include "numerics/pair.glsl"
#include "lib/naive/attenuation.glsl"

float call() { return naive_inverse_square(argument(0)); }
