// (lo, hi, o, d, extent, t_max) -> entry
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 14
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/ray_box.glsl"

void kernel() {
    result(0, slab(box_ray(argument3(6), argument3(9), argument(12)), argument3(0), argument3(3), argument(13)));
}
