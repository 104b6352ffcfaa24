// Adaptive sampling (S26): pixels from their quadtrees; a leaf is the mean of its four corners and counts by its area.
// In: radiance at the points of the lattice, states; the deepest level whose points are all traced. Out: an image of linear radiance.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "raytrace/lattice.glsl"

layout(set = 0, binding = 0, scalar) readonly buffer Lattice { vec4 radiance[]; };
layout(set = 0, binding = 1, scalar) readonly buffer States { uint states[]; };
layout(set = 0, binding = 2, rgba32f) writeonly uniform image2D frame;

// Every second bit of a place on the Morton curve, which visits the four quarters of a cell one after the other; 12 bits. No loop: its
// rounds would count against those that a CPU driver allows.
uint every_second_bit(uint code) {
    uint n = code & 0x555u;
    n = (n | n >> 1u) & 0x333u;
    n = (n | n >> 2u) & 0x30fu;
    return (n | n >> 4u) & 0x3fu;
}

void main() {
    uint i = invocation();
    if (i >= push.count) return;
    uvec2 pixel = uvec2(i % push.size.x, i / push.size.x), first = pixel << push.levels;
    uint end = 1u << (2u * push.levels), level = 0u;
    vec3 mean = vec3(0.0);
    // One round a cell of the tree, 5461 at most. `code` counts finest cells.
    for (uint code = 0u; code < end;) {
        uint side = cell_side(level);
        uvec2 corner = first + uvec2(every_second_bit(code), every_second_bit(code >> 1u));
        if (level < push.level && states[point_index(corner + (side >> 1u))] != 0u) {
            ++level;
            continue;
        }
        vec3 leaf = 0.25 * ((radiance[point_index(corner)].rgb + radiance[point_index(corner + uvec2(side, 0u))].rgb) +
                            (radiance[point_index(corner + uvec2(0u, side))].rgb + radiance[point_index(corner + side)].rgb));
        // A running mean, so that equal corners give their color to the bit (AA-4).
        uint area = side * side;
        mean = code == 0u ? leaf : mean + (leaf - mean) * (float(area) / float(code + area));
        code += area;
        // The next cell is of the coarsest level that begins there: its parents are known to be split.
        uint aligned = code == 0u ? push.levels : uint(findLSB(code)) >> 1u;
        level = push.levels - min(aligned, push.levels);
    }
    imageStore(frame, ivec2(push.corner + pixel), vec4(mean, 1.0));
}
