// What the passes of a stable counting sort share (Knuth 1973, "Sorting and Searching", 5.2, algorithm D; 5.2.5). A lane takes a run of
// elements in order and counts in registers: on CPU drivers these are eight times cheaper than counters in a buffer, and few lanes are enough.
#ifndef LIGHTBENCH_ACCEL_SORT_GLSL
#define LIGHTBENCH_ACCEL_SORT_GLSL

#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/build.h"
#include "fetch.glsl"

layout(push_constant, scalar) uniform Push { SortPush push; };
layout(constant_id = CONSTANT_SORT_DIGITS) const uint kDigits = kSortDigits;

uint digit_of(uint key) { return key >> push.shift & (kDigits - 1u); }

#endif
