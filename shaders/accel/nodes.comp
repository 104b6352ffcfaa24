// The nodes that stay, one after the other. In: which they are, their ranges, the pyramid of boxes. Out: for each the boxes of its children
// and references to them, exact, and as the narrow tree has them; the parent of each.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

FETCH_BOXES(pyramid, 0)
FETCH_WORDS(order, 2) // hierarchy's numbers of the nodes that stay
FETCH_WORDS(numbers, 4) // and where in that order each is
FETCH_TABLE(ranges, FETCH_BUILD, 6)
FETCH_WORDS(types, 8)
FETCH_WORDS(ranks, 10) // of primitives, by type
layout(set = 0, binding = 12, scalar) writeonly buffer Nodes { uvec4 nodes[]; };
layout(set = 0, binding = 13, scalar) writeonly buffer Narrow { uvec4 narrow[]; };
layout(set = 0, binding = 14, scalar) writeonly buffer Parents { uint parents[]; };

// Nodes of the pyramid that cover the places from first to last: on each level at most one at either end is needed, and taking both does
// no harm, for they lie within.
Box box_of_range(uint first, uint last) {
    Box box = kEmptyBox;
    for (uint a = push.leaves + first, b = push.leaves + last; a <= b; a = (a + 1u) >> 1u, b = (b - 1u) >> 1u)
        box = join(box, join(pyramid_box(a), pyramid_box(b)));
    return box;
}

uint reference_to(uint first, uint last, uint node, uint parent) {
    uint number = numbers_word(node);
    if (first < last && number < push.count) {
        parents[number] = parent;
        return number;
    }
    uint type = kManyTypes ? types_word(first) : type_of_item(0u), index = kManyTypes ? ranks_word(first) - first_of_type(type) : first;
    return kRefLeaf | type << kRefType | (last - first) << kRefCount | index;
}

// Three roundings of a number up to 65536, and the sum: push.margin has 1/32 for them.
uvec3 planes(Box box) {
    uvec3 low = uvec3(clamp(floor((box.low - push.origin) * push.per_step - push.margin), vec3(0.0), vec3(65535.0)));
    uvec3 high = uvec3(clamp(ceil((box.high - push.origin) * push.per_step + push.margin), vec3(0.0), vec3(65535.0)));
    return low | high << 16u;
}

void write_child(uint node, uint child, Box box, uint reference) {
    uint at = kBuildNodeTexels * node + 2u * child;
    nodes[at] = uvec4(floatBitsToUint(box.low), reference);
    nodes[at + 1u] = uvec4(floatBitsToUint(box.high), 0u);
    narrow[2u + kNarrowTexels * node + child] = uvec4(planes(box), reference);
}

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    uvec3 range = fetch_ranges(order_word(i)).xyz;
    write_child(i, 0u, box_of_range(range.x, range.z), reference_to(range.x, range.z, range.z, i));
    write_child(i, 1u, box_of_range(range.z + 1u, range.y), reference_to(range.z + 1u, range.y, range.z + 1u, i));
}
