// (any float) -> ordered_word: its upper and its lower 16 bits, which floats hold exactly; whether ordered_float leads back
#version 460
#extension GL_GOOGLE_include_directive : require
#define KERNEL_ARGUMENTS 1
#define KERNEL_RESULTS 3
#include "numerics/kernel.glsl"
#include "lib/morton.glsl"

void kernel() {
    uint word = ordered_word(argument(0));
    result(0, float(word >> 16u));
    result(1, float(word & 0xffffu));
    result(2, float(floatBitsToUint(ordered_float(word)) == floatBitsToUint(argument(0))));
}
