// Adaptive sampling (S26): lists the points of a level that were asked for, at level 0 all that are not traced yet. In: states.
// Out: the list that eye rays go through: position in the picture, key of random numbers, index in the lattice.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "raytrace/lattice.glsl"
#include "lib/random.glsl"
#include "raytrace/tile.glsl"

layout(set = 0, binding = 0, scalar) buffer States { uint states[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Points { uvec4 points[]; };
layout(set = 0, binding = 2, scalar) buffer Listed { uint listed; };

// The key depends on where in the picture the point lies, in units of the finest lattice that there is: not on the crop or the levels.
void main() {
    uint i = invocation();
    if (i >= push.count) return;
    uvec2 p = tile_pixel(i, (push.size << push.level) + 1u) * cell_side(push.level);
    uint index = point_index(p), state = states[index];
    if (state == kTraced || (state == kIdle && push.level > 0u)) return;
    states[index] = kTraced;
    vec2 at = vec2(push.corner) + vec2(p) / float(1u << push.levels);
    uvec2 finest = (push.corner << kMaxLatticeLevels) + (p << (kMaxLatticeLevels - push.levels));
    points[atomicAdd(listed, 1u)] = uvec4(floatBitsToUint(at), hash4(uvec4(finest, 0u, push.seed)).z, index);
}
