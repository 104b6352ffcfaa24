// (high, low, threshold) -> 1 if the contrast is above it, else 0: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 3
#include "numerics/pair.glsl"
#include "lib/contrast.glsl"
#include "lib/naive/contrast.glsl"

float call() {
    if (kForm == 1) return contrast_exceeds(argument(0), argument(1), argument(2)) ? 1.0 : 0.0;
    return naive_contrast(argument(0), argument(1), argument(2));
}
