// (n, l, v, shininess) -> specular factor: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 10
#include "numerics/pair.glsl"
#include "lib/phong.glsl"
#include "lib/naive/phong.glsl"

float call() {
    if (kForm == 1) return phong_specular(argument3(0), argument3(3), argument3(6), argument(9));
    return naive_phong(argument3(0), argument3(3), argument3(6), argument(9));
}
