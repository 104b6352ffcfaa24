// (t) -> arc_tangent
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/form_factor.glsl"

void kernel() { result(0, arc_tangent(argument(0))); }
