// First link of the chain: target = source * source + added. A constant chooses where the source is read from.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kFetchStorage = 0u;
layout(set = 0, binding = 0) uniform utextureBuffer source;
layout(set = 0, binding = 1, scalar) readonly buffer source_storage { uvec4 source_words[]; };
layout(set = 0, binding = 2, scalar) writeonly buffer Squares { uvec4 squares[]; };
layout(push_constant, scalar) uniform Push { uint count, added; } push;

uvec4 fetch(uint i) { return kFetchStorage != 0u ? source_words[i] : texelFetch(source, int(i)); }

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < push.count) squares[i] = fetch(i) * fetch(i) + push.added;
}
