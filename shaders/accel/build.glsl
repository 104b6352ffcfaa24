// What the passes of the build share: their push constants and extensions, which invocation one is, boxes.
#ifndef LIGHTBENCH_ACCEL_BUILD_GLSL
#define LIGHTBENCH_ACCEL_BUILD_GLSL

#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/build.h"
#include "fetch.glsl"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { BuildPush push; };
layout(constant_id = CONSTANT_BUILD_TYPES) const uint kTypes = 7u;

const bool kManyTypes = (kTypes & (kTypes - 1u)) != 0u;

uint invocation() { return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

// kType... of a primitive by its number among those in the tree.
uint type_of_item(uint item) {
    if (!kManyTypes) return (kTypes & 1u) != 0u ? kTypeTriangle : (kTypes & 2u) != 0u ? kTypeSphere : kTypeShape;
    return uint(item >= push.triangles) + uint(item >= push.triangles + push.spheres);
}

// Number of the first of a type.
uint first_of_type(uint type) { return type == kTypeTriangle ? 0u : type == kTypeSphere ? push.triangles : push.triangles + push.spheres; }

struct Box {
    vec3 low, high;
};
const Box kEmptyBox = Box(vec3(3.4e38), vec3(-3.4e38));

Box join(Box a, Box b) { return Box(min(a.low, b.low), max(a.high, b.high)); }

// Of a table of words, four a texel.
uint word_of(uvec4 texel, uint i) {
    uint low = (i & 1u) != 0u ? texel.y : texel.x, high = (i & 1u) != 0u ? texel.w : texel.z;
    return (i & 2u) != 0u ? high : low;
}
#define FETCH_WORDS(NAME, BINDING)             \
    FETCH_TABLE(NAME, FETCH_BUILD, BINDING)    \
    uint NAME##_word(uint i) { return word_of(fetch_##NAME(i >> 2u), i); }

#define FETCH_BOXES(NAME, BINDING)          \
    FETCH_TABLE(NAME, FETCH_BUILD, BINDING) \
    Box NAME##_box(uint i) {                \
        return Box(uintBitsToFloat(fetch_##NAME(kBoxTexels * i).xyz), uintBitsToFloat(fetch_##NAME(kBoxTexels * i + 1u).xyz)); \
    }

#endif
