// (o, d, c, r, after) -> t: stable and naive
#version 460
#extension GL_GOOGLE_include_directive : require
#define PAIR_ARGUMENTS 11
#include "numerics/pair.glsl"
#include "lib/ray_sphere.glsl"
#include "lib/naive/sphere.glsl"

float call() {
    if (kForm == 1) return ray_sphere(argument3(0), argument3(3), argument3(6), argument(9), argument(10));
    return naive_sphere(argument3(0), argument3(3), argument3(6), argument(9), argument(10));
}
