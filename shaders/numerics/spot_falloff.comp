// (cos_angle, cos_outer, cos_inner) -> spot_falloff
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/spot.glsl"

void kernel() { result(0, spot_falloff(argument(0), argument(1), argument(2))); }
