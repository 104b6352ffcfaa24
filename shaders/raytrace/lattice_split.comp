// Adaptive sampling (S26): which cells of a level are split, and the points that this asks for. In: radiance at the corners of the cells.
// Out: states of points. Cells that share a point may ask for it twice, with the same word.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/contrast.glsl"
#include "raytrace/lattice.glsl"

layout(set = 0, binding = 0, scalar) readonly buffer Lattice { vec4 radiance[]; };
layout(set = 0, binding = 1, scalar) buffer States { uint states[]; };

// In some channel.
bool is_rough(vec3 a, vec3 b, vec3 c, vec3 d) {
    vec3 high = max(max(a, b), max(c, d)), low = min(min(a, b), min(c, d));
    for (int i = 0; i < 3; ++i)
        if (contrast_exceeds(high[i], low[i], push.contrast[i])) return true;
    return false;
}

void ask_for(uvec2 p) {
    uint i = point_index(p);
    if (states[i] == kIdle) states[i] = kAskedFor;
}

void main() {
    uint i = invocation(), columns = push.size.x << push.level;
    if (i >= push.count) return;
    uint side = cell_side(push.level), half_side = side >> 1u;
    uvec2 cell = uvec2(i % columns, i / columns), corner = cell * side;
    if (push.level > 0u && states[point_index((cell >> 1u) * 2u * side + side)] == kIdle) return; // its parent is whole
    vec3 a = radiance[point_index(corner)].rgb, b = radiance[point_index(corner + uvec2(side, 0u))].rgb,
         c = radiance[point_index(corner + uvec2(0u, side))].rgb, d = radiance[point_index(corner + side)].rgb;
    if (!is_rough(a, b, c, d)) return;
    ask_for(corner + half_side);
    ask_for(corner + uvec2(half_side, 0u));
    ask_for(corner + uvec2(0u, half_side));
    ask_for(corner + uvec2(side, half_side));
    ask_for(corner + uvec2(half_side, side));
}
