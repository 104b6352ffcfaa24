// (x) -> quantize8(x), quantize8(srgb_encode(x))
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/color.glsl"

void kernel() {
    result(0, float(quantize8(argument(0))));
    result(1, float(quantize8(srgb_encode(argument(0)))));
}
