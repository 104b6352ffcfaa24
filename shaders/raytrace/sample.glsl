// Where in its pixel a sample lies: for the ray that is sent there, and for the filter that weighs it. Needs wants_ray().
#ifndef LIGHTBENCH_RAYTRACE_SAMPLE_GLSL
#define LIGHTBENCH_RAYTRACE_SAMPLE_GLSL

#include "lib/random.glsl"

//   shift  of the sample; of a jittered one: where its cell begins
//   cell   side of the cell
//   key    what numbers of the ray are drawn from
//   returns the offset from the pixel's upper left corner, pixels, in [0, 1]
vec2 sample_within(uvec2 pixel, uint sample_index, uint seed, vec2 shift, float cell, out uint key) {
    uvec4 words = hash4(uvec4(pixel, sample_index, seed));
    key = words.z;
    if (wants_ray(RAY_JITTER)) return shift + cell * vec2(words.xy >> 8u) * 5.9604645e-8;
    return shift;
}

#endif
