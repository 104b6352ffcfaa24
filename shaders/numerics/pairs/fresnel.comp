// (c, n) -> reflectance: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 2
#include "numerics/pair.glsl"
#include "lib/fresnel.glsl"
#include "lib/naive/fresnel.glsl"

float call() {
    if (kForm == 1) return fresnel(argument(0), argument(1));
    return naive_fresnel(argument(0), argument(1));
}
