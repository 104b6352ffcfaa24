// (first, term, count) -> first and `count` times the term, added one by one
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 3
#define KERNEL_RESULTS 1
#include "numerics/kernel.glsl"
#include "lib/sum.glsl"

void kernel() {
    Sum3 sum = sum_start();
    sum_add(sum, vec3(argument(0)));
    uint count = uint(argument(2)), added = 0;
    for (; added < count; ++added) sum_add(sum, vec3(argument(1)));
    finished = added == count;
    result(0, sum_result(sum).x);
}
