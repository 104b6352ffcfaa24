// Walks through the grid of voxels. Amanatides, Woo 1987, "A Fast Voxel Traversal Algorithm for Ray Tracing", with distances of planes from
// their numbers. In: the global ray. Out: the nearest hit, or with `first` the first that is found.
#ifndef LIGHTBENCH_RAYTRACE_WALK_GRID_GLSL
#define LIGHTBENCH_RAYTRACE_WALK_GRID_GLSL

#include "raytrace/voxels.glsl"

uvec2 grid_list(VoxelSpace space, uvec3 at) {
    uint cell = at.x + space.cells.x * (at.y + space.cells.y * at.z);
    uvec4 pair = fetch_nodes(kGridHeaderTexels + (cell >> 1u));
    return (cell & 1u) == 0u ? pair.xy : pair.zw;
}

uvec3 grid_cell(VoxelSpace space, uint cell) {
    uint row = cell / space.cells.x;
    return uvec3(cell - row * space.cells.x, row % space.cells.y, row / space.cells.y);
}

// A hit beyond the voxel does not end the walk: something in a later voxel may be nearer (TS-6). One up to its end does: whatever is nearer
// has been met. A step leaves by one plane, so there are no more of them than the three sides have cells (TS-8).
// Put down: node is the cell, top 0, a how much of its list is done.
bool walk_grid(inout RayHit hit, bool first, inout Walk w) {
    mailbox = uvec4(kNothing); // of this walk: the next one of the same ray looks behind what this one found
    uvec4 x = fetch_nodes(0u), y = fetch_nodes(1u), z = fetch_nodes(2u);
    VoxelSpace space = VoxelSpace(uintBitsToFloat(x.xyz), uintBitsToFloat(y.xyz), uvec3(x.w, y.w, z.x));
    bool begins = w.top != 0u;
    float start = enter_voxels(space, hit.t);
    uvec3 at = begins ? voxel_at(space, start == kNoHit ? 0.0 : start) : grid_cell(space, w.node == kNothing ? 0u : w.node);
    uvec3 ahead = uvec3(greaterThan(ray.inv_d, vec3(0.0))), move = 2u * ahead - 1u; // -1 wraps around, and out of the grid
    bool ended = w.node == kNothing || (begins && start == kNoHit);
    uvec2 list = grid_list(space, at);
    uint place = list.x + (begins ? 0u : w.a), end = list.x + list.y, steps = 0u;
    if (wants_ray(RAY_COUNT) && begins && !ended) ++count_voxels;
    while (!ended && steps < kStepBudget) {
        while (place < end && !ended && steps < kStepBudget) {
            test_listed(z.y, place, hit);
            ended = first && hit.ref != kNothing;
            ++place;
            steps += 2u;
        }
        while (place >= end && !ended && steps < kStepBudget) {
            vec3 t = plane_distances(space, at + ahead);
            float leave = min(t.x, min(t.y, t.z));
            bvec3 through = bvec3(t.x == leave, t.y == leave && t.x > leave, t.z == leave && t.x > leave && t.y > leave);
            uvec3 next = at + mix(uvec3(0u), move, through);
            ended = hit.t <= leave || any(greaterThanEqual(next, space.cells));
            at = ended ? at : next;
            list = grid_list(space, at);
            place = list.x, end = list.x + list.y;
            ++steps;
            if (wants_ray(RAY_COUNT) && !ended) ++count_voxels;
        }
    }
    w.node = ended ? kNothing : at.x + space.cells.x * (at.y + space.cells.y * at.z);
    w.top = 0u, w.a = place - list.x;
    return ended;
}

#endif
