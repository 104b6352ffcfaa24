// (d) -> factor: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 1
#include "numerics/pair.glsl"
#include "lib/attenuation.glsl"
#include "lib/naive/attenuation.glsl"

float call() {
    if (kForm == 1) return attenuation_inverse_square(argument(0));
    return naive_inverse_square(argument(0));
}
