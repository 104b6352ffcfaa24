// How many levels lie below the root: from each node that has no node below it, up. In: nodes, parents. Out: the largest number.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

FETCH_TABLE(nodes, FETCH_BUILD, 0)
FETCH_WORDS(parents, 2)
layout(set = 0, binding = 4, scalar) buffer Bounds { BuildBounds bounds; };

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    uint at = kBuildNodeTexels * i;
    bool lowest = (fetch_nodes(at).w & fetch_nodes(at + 2u).w & kRefLeaf) != 0u;
    uint depth = 1u;
    for (uint node = lowest ? i : 0u; node != 0u; node = parents_word(node)) ++depth;
    if (lowest) atomicMin(bounds.deepest, ~depth);
}
