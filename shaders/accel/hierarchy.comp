// The hierarchy of the codes' common prefixes, each inner node by itself. Karras 2012, "Maximizing Parallelism in the Construction of BVHs,
// Octrees, and k-d Trees", sec. 4; equal codes differ by their places. In: codes in order, types. Out: of each node the first and the last
// of its primitives, and the last of its first child; flags.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "accel/build.glsl"

FETCH_WORDS(keys, 0)
FETCH_WORDS(types, 2)
layout(set = 0, binding = 4, scalar) writeonly buffer Ranges { uvec4 ranges[]; };
layout(set = 0, binding = 5, scalar) writeonly buffer Flags { uint flags[]; }; // 0: stays a node; 1: is part of a leaf

uint key, place; // of this node's end

// What two places do not share: a longer common prefix means a smaller highest bit.
uvec2 difference(int other) {
    uint at = uint(clamp(other, 0, int(push.items) - 1));
    return uvec2(key ^ keys_word(at), place ^ at);
}
bool before(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }
bool inside(int other) { return other >= 0 && other < int(push.items); }
uint highest(uint x) { return x == 0u ? 0u : 1u << uint(findMSB(x)); }
// Everything below this has a longer common prefix.
uvec2 prefix_of(uvec2 differing) { return differing.x != 0u ? uvec2(highest(differing.x), 0u) : uvec2(0u, highest(differing.y)); }
bool shares(int other, uvec2 prefix) { return inside(other) && before(difference(other), prefix); }

uint last_step(int direction, uvec2 prefix) {
    uint most = 2u, steps = 0u;
    while (most < push.items && shares(int(place) + int(most) * direction, prefix)) most *= 2u;
    for (uint t = most / 2u; t > 0u; t /= 2u)
        if (shares(int(place) + int(steps + t) * direction, prefix)) steps += t;
    return steps;
}

bool one_type(uint first, uint last) {
    if (!kManyTypes) return true;
    uint type = types_word(first);
    bool same = true;
    for (uint i = first + 1u; i <= min(last, first + 3u); ++i) same = same && types_word(i) == type;
    return same;
}

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    place = i, key = keys_word(i);
    int direction = i == 0u || before(difference(int(i) + 1), difference(int(i) - 1)) ? 1 : -1;
    uvec2 outside = i == 0u ? uvec2(0xffffffffu) : prefix_of(difference(int(i) - direction));
    uint steps = last_step(direction, outside);
    uvec2 prefix = prefix_of(difference(int(i) + int(steps) * direction));
    uint split = 0u;
    for (uint t = steps; t > 1u;) {
        t = (t + 1u) / 2u;
        if (shares(int(i) + int(split + t) * direction, prefix)) split += t;
    }
    uint first = direction > 0 ? i : i - steps, last = direction > 0 ? i + steps : i;
    ranges[i] = uvec4(first, last, direction > 0 ? i + split : i - split - 1u, 0u);
    flags[i] = uint(i > 0u && last - first < push.leaf && one_type(first, last));
}
