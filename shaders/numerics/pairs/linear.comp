// (d, d0) -> factor: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 2
#include "numerics/pair.glsl"
#include "lib/attenuation.glsl"
#include "lib/naive/attenuation.glsl"

float call() {
    if (kForm == 1) return attenuation_linear(argument(0), argument(1));
    return naive_linear(argument(0), argument(1));
}
