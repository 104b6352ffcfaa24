// (cell: three integers below 1024) -> morton_code: its upper and its lower 15 bits, which floats hold exactly
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 2
#include "numerics/kernel.glsl"
#include "lib/morton.glsl"

void kernel() {
    uint code = morton_code(uvec3(argument3(0)));
    result(0, float(code >> 15u));
    result(1, float(code & 0x7fffu));
}
