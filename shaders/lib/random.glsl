// Random numbers without a state: four uniform numbers from a key of four. The same on every device.
#ifndef LIGHTBENCH_LIB_RANDOM
#define LIGHTBENCH_LIB_RANDOM

// Jarzynski, Olano 2020, "Hash functions for GPU rendering", JCGT 9(3), pcg4d: all four numbers of the result depend on all of the key.
uvec4 hash4(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Four uniform numbers in [0, 1), multiples of 2^-24: what floats hold exactly.
//   key      pixel, sample, dimension, seed
// Uniform, and independent between keys that follow each other in any of the four (kernel tests RandomIsUniform, RandomIsIndependent).
vec4 random_unit4(uvec4 key) { return vec4(hash4(key) >> 8u) * 5.9604645e-08; }

#endif
