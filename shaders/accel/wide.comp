// Nodes with four children from those with two: of a node that stays, the children of its children; where that is three, the larger of
// the two that came out of one is opened once more. So each level of it takes two levels of the other at least. A node for each of the
// binary ones, of which walks see those that they come to. In: nodes. Out: wide nodes.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

FETCH_TABLE(nodes, FETCH_BUILD, 0)
layout(set = 0, binding = 2, scalar) writeonly buffer Wide { uvec4 wide[]; };

struct Child {
    vec3 low, high;
    uint reference;
};
const Child kAbsent = Child(vec3(3.4e38), vec3(-3.4e38), kNothing);

Child child_of(uint node, uint i) {
    uint at = kBuildNodeTexels * node + 2u * i;
    uvec4 low = fetch_nodes(at);
    return Child(uintBitsToFloat(low.xyz), uintBitsToFloat(fetch_nodes(at + 1u).xyz), low.w);
}

bool is_node(Child c) { return (c.reference & kRefLeaf) == 0u; }

float area(Child c) {
    vec3 d = c.high - c.low;
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

// Both children of a node; of a leaf itself, and nothing.
void open(Child c, out Child a, out Child b) {
    bool node = is_node(c);
    uint n = node ? c.reference : 0u;
    a = child_of(n, 0u), b = child_of(n, 1u);
    if (!node) a = c, b = kAbsent;
}

// Into the larger and the room that a leaf beside them has left.
void open_larger(inout Child a, inout Child b, inout Child room) {
    bool first = is_node(a) && (!is_node(b) || area(a) >= area(b));
    Child larger = first ? a : b, one, two;
    open(larger, one, two);
    if (first) a = one; else b = one;
    room = two;
}

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    Child c[4], left = child_of(i, 0u), right = child_of(i, 1u);
    open(left, c[0], c[1]);
    open(right, c[2], c[3]);
    if (is_node(left) != is_node(right)) {
        Child a = is_node(left) ? c[0] : c[2], b = is_node(left) ? c[1] : c[3], room = kAbsent, leaf = is_node(left) ? c[2] : c[0];
        open_larger(a, b, room);
        c[0] = a, c[1] = b, c[2] = room, c[3] = leaf;
    }
    uint at = kWideTexels * i;
    for (int axis = 0; axis < 3; ++axis) {
        wide[at + 2u * axis] = floatBitsToUint(vec4(c[0].low[axis], c[1].low[axis], c[2].low[axis], c[3].low[axis]));
        wide[at + 2u * axis + 1u] = floatBitsToUint(vec4(c[0].high[axis], c[1].high[axis], c[2].high[axis], c[3].high[axis]));
    }
    wide[at + 6u] = uvec4(c[0].reference, c[1].reference, c[2].reference, c[3].reference);
    wide[at + 7u] = uvec4(0u);
}
