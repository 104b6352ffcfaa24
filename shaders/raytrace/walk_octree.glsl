// Walks through the octree from leaf to leaf. Glassner 1984, "Space Subdivision for Fast Ray Tracing": the voxel behind the one that is left
// is looked up from the root; Laine, Karras 2010, "Efficient Sparse Voxel Octrees": from the node that both lie in.
// In: the global ray. Out: the nearest hit, or with `first` the first that is found.
#ifndef LIGHTBENCH_RAYTRACE_WALK_OCTREE_GLSL
#define LIGHTBENCH_RAYTRACE_WALK_OCTREE_GLSL

#include "raytrace/voxels.glsl"

// A leaf on the ray's way.
struct OctreeLeaf {
    uvec3 at;    // the finest voxel in which the ray is, numbers of planes
    uint depth;  // of the leaf
    uint name;   // kRefLeaf | index, or kNothing
};

// Goes down from the node `name` at leaf.depth to the leaf around leaf.at; the nodes on the way stay in the stack, by their depth.
void octree_descend(uint name, inout OctreeLeaf leaf) {
    while ((name & kRefLeaf) == 0u) {
        stack[leaf.depth] = name;
        uvec3 octant = (leaf.at >> (kOctreeDepth - 1u - leaf.depth)) & 1u;
        name = word_of(fetch_nodes(kOctreeHeaderTexels + kOctreeNodeTexels * name + octant.z), octant.x | octant.y << 1u);
        ++leaf.depth;
        if (wants_ray(RAY_COUNT)) ++count_nodes;
    }
    leaf.name = name;
}

// First reference, and their number.
uvec2 octree_list(OctreeLeaf leaf, uint leaves) {
    uint index = leaf.name == kNothing ? 0u : leaf.name & ~kRefLeaf;
    uvec4 pair = fetch_nodes(leaves + (index >> 1u));
    return leaf.name == kNothing ? uvec2(0u) : (index & 1u) == 0u ? pair.xy : pair.zw;
}

// Where the ray leaves the leaf, and in `next` the finest voxel behind. Across the axis that it leaves by, the point stays within the leaf and
// does not go back, whatever rounding says: so every step ends nearer to the end of the way (TS-9).
float octree_leave(VoxelSpace space, OctreeLeaf leaf, out uvec3 next) {
    uint side = kOctreeSide >> leaf.depth;
    uvec3 low = leaf.at & ~(side - 1u), high = low + (side - 1u);
    bvec3 forward = greaterThan(ray.inv_d, vec3(0.0));
    vec3 t = plane_distances(space, mix(low, low + side, forward));
    float leave = min(t.x, min(t.y, t.z));
    bvec3 through = bvec3(t.x == leave, t.y == leave && t.x > leave, t.z == leave && t.x > leave && t.y > leave);
    uvec3 inside = clamp(voxel_at(space, leave), mix(low, leaf.at, forward), mix(leaf.at, high, forward));
    next = mix(inside, mix(low - 1u, low + side, forward), through); // below 0 it wraps around, and out
    return leave;
}

// Put down: top 3, stack[0 .. 2] the finest voxel, a how much of its leaf's list is done.
bool walk_octree(inout RayHit hit, bool first, inout Walk w) {
    mailbox = uvec4(kNothing); // of this walk: the next one of the same ray looks behind what this one found
    uvec4 x = fetch_nodes(0u), y = fetch_nodes(1u), z = fetch_nodes(2u);
    VoxelSpace space = VoxelSpace(uintBitsToFloat(x.xyz), uintBitsToFloat(y.xyz), uvec3(kOctreeSide));
    bool begins = w.top != 3u;
    float start = enter_voxels(space, hit.t);
    bool ended = w.node == kNothing || (begins && start == kNoHit);
    uvec3 resumed = begins ? uvec3(0u) : uvec3(stack[0], stack[1], stack[2]);
    OctreeLeaf leaf = OctreeLeaf(begins ? voxel_at(space, start == kNoHit ? 0.0 : start) : resumed, 0u, kNothing);
    octree_descend(ended ? kNothing : x.w, leaf);
    uvec2 list = octree_list(leaf, y.w);
    uint place = list.x + (begins ? 0u : w.a), end = list.x + list.y, steps = 0u;
    if (wants_ray(RAY_COUNT) && begins && !ended) ++count_voxels;
    while (!ended && steps < kStepBudget) {
        while (place < end && !ended && steps < kStepBudget) {
            test_listed(z.x, place, hit);
            ended = first && hit.ref != kNothing;
            ++place;
            steps += 2u;
        }
        while (place >= end && !ended && steps < kStepBudget) {
            uvec3 next;
            float leave = octree_leave(space, leaf, next);
            ended = hit.t <= leave || any(greaterThanEqual(next, uvec3(kOctreeSide)));
            uvec3 differs = next ^ leaf.at;
            leaf.at = ended ? leaf.at : next;
            leaf.depth = kOctreeDepth - 1u - min(uint(findMSB(differs.x | differs.y | differs.z)), kOctreeDepth - 1u);
            octree_descend(ended ? kNothing : stack[leaf.depth], leaf);
            list = octree_list(leaf, y.w);
            place = list.x, end = list.x + list.y;
            steps += 4u;
            if (wants_ray(RAY_COUNT) && !ended) ++count_voxels;
        }
    }
    w.node = ended ? kNothing : 0u, w.top = 3u, w.a = place - list.x;
    stack[0] = leaf.at.x, stack[1] = leaf.at.y, stack[2] = leaf.at.z;
    return ended;
}

#endif
