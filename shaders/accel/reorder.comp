// Primitives of one type go to where leaves look for them. In: their order, the table by number. Out: the table in that order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

layout(constant_id = CONSTANT_COPY_TEXELS) const uint kTexels = 3u;
FETCH_WORDS(order, 0)
FETCH_TABLE(table, FETCH_BUILD, 2)
layout(set = 0, binding = 4, scalar) writeonly buffer Ordered { uvec4 ordered[]; };

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    uint from = kTexels * (order_word(push.first + i) - push.first), to = kTexels * i;
    for (uint t = 0u; t < kTexels; ++t) ordered[to + t] = fetch_table(from + t);
}
