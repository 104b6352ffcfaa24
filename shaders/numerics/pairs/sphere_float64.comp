// (o, d, c, r, after) -> t: naive, in float64
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 11
#define LIGHTBENCH_FLOAT64
#include "numerics/pair.glsl"
#include "lib/naive/sphere.glsl"

float call() { return naive_sphere(argument3(0), argument3(3), argument3(6), argument(9), argument(10)); }
