// (x) -> x, but only where x > 0 does the kernel finish: the host must notice the others
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"

void kernel() {
    finished = argument(0) > 0.0;
    result(0, argument(0));
}
