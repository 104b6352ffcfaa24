// Up to three levels of the pyramid: node i holds nodes 2 i and 2 i + 1, node 1 everything. In: the level below. Out: those above it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

FETCH_BOXES(pyramid, 0)
layout(set = 0, binding = 2, scalar) writeonly buffer Pyramid { uvec4 joined_boxes[]; };

Box joined(uint node, Box a, Box b) {
    Box box = join(a, b);
    joined_boxes[kBoxTexels * node] = uvec4(floatBitsToUint(box.low), 0u);
    joined_boxes[kBoxTexels * node + 1u] = uvec4(floatBitsToUint(box.high), 0u);
    return box;
}

Box joined_pair(uint node) { return joined(node, pyramid_box(2u * node), pyramid_box(2u * node + 1u)); }

Box joined_four(uint node) {
    Box a = joined_pair(2u * node), b = joined_pair(2u * node + 1u);
    return joined(node, a, b);
}

void main() {
    uint i = invocation(), node = push.first + i;
    if (i >= push.count) return;
    if (push.levels == 1u) {
        joined_pair(node);
    } else if (push.levels == 2u) {
        joined_four(node);
    } else {
        Box a = joined_four(2u * node), b = joined_four(2u * node + 1u);
        joined(node, a, b);
    }
}
