// For tests of specialisation: bit 0 of the mask reads `first`, bit 1 reads `second` in a loop, through functions as real shaders do.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kMask = 3u;
layout(constant_id = 1) const float kFactor = 1.0;

layout(set = 0, binding = 0) uniform utextureBuffer first;
layout(set = 0, binding = 1, scalar) readonly buffer Second { uint second_values[]; };
layout(set = 1, binding = 2, scalar) writeonly buffer Target {
    uint count;
    vec3 values[];
} target;

layout(push_constant, scalar) uniform Push {
    vec3 offset;
    uint count;
} push;

bool wants(uint bit) { return (kMask & bit) != 0u; }

float from_first(uint i) { return uintBitsToFloat(texelFetch(first, int(i)).x); }

float from_second(uint i) {
    float sum = 0.0;
    for (uint k = 0u; k < push.count; ++k) sum += float(second_values[i + k]);
    return sum;
}

float gather(uint i) {
    float sum = 0.0;
    if (wants(1u)) sum += from_first(i);
    if (!wants(2u)) return sum;
    return sum + from_second(i);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < push.count) target.values[i] = push.offset + gather(i) * kFactor;
}
