// (o, d, m, after) -> t: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 8
#include "numerics/pair.glsl"
#include "lib/ray_torus.glsl"
#include "lib/naive/torus.glsl"

float call() {
    if (kForm == 1) return ray_torus(argument3(0), argument3(3), argument(6), argument(7));
    return naive_torus(argument3(0), argument3(3), argument(6), argument(7));
}
