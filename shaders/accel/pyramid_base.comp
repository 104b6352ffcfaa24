// The lowest level of a pyramid of boxes: those of the primitives along the curve, then empty ones. In: order, boxes by number. Out: the
// level; types in that order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

FETCH_BOXES(boxes, 0)
FETCH_WORDS(order, 2)
layout(set = 0, binding = 4, scalar) writeonly buffer Pyramid { uvec4 pyramid[]; };
layout(set = 0, binding = 5, scalar) writeonly buffer Types { uint types[]; };

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    Box box = kEmptyBox;
    if (i < push.items) {
        uint item = order_word(i);
        box = boxes_box(item);
        if (kManyTypes) types[i] = type_of_item(item);
    }
    uint at = kBoxTexels * (push.leaves + i);
    pyramid[at] = uvec4(floatBitsToUint(box.low), 0u);
    pyramid[at + 1u] = uvec4(floatBitsToUint(box.high), 0u);
}
