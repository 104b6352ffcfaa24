// (high, low, threshold) -> 1 if the contrast is above it, else 0: naive, in float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 3
#define LIGHTBENCH_FLOAT64
#include "numerics/pair.glsl"
#include "lib/naive/contrast.glsl"

float call() { return naive_contrast(argument(0), argument(1), argument(2)); }
