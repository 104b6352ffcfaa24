// Acceleration structures as the shaders read them (shaders/shared/rays.h). In: primitives, what is asked for. Out: tables of texels, and
// the primitives in the order that the structure refers to. Pure, no Vulkan; built on all cores, the same bytes whatever their number.
#pragma once

#include "accel/primitives.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lightbench {

enum class Accel { none, bvh, sphere_bvh, grid, octree }; // as ACCEL_...

// 0 or empty: chosen by the builder.
struct AccelRequest {
    Accel accel = Accel::bvh;
    std::uint32_t leaf = 0;               // primitives of a leaf at most, 1 to 4 (bvh, sphere-bvh); of a voxel before it is split (octree)
    std::array<std::uint32_t, 3> cells{}; // of the grid
    double density = 0;                   // cells of the grid a primitive, where `cells` is 0
    std::uint32_t depth = 0;              // of the octree at most
    unsigned threads = 0;                 // that build; 0: one a core
};

struct AccelTables {
    Accel accel = Accel::bvh;
    std::vector<gpu_layout::uvec4> nodes;  // bvh: wide; sphere-bvh, grid, octree: all there is; none: empty
    std::vector<gpu_layout::uvec4> narrow; // bvh only
    glm::vec3 narrow_origin{0};            // frame: plane q of the narrow tree lies at origin + q * step
    glm::vec3 narrow_step{1};
    double narrow_inflation = 1;                     // cost of the narrow tree over that of exact boxes (surface-area heuristic)
    std::uint32_t stack = 0;                         // entries of a stack that a walk needs at most (bvh: the larger of both trees)
    std::size_t node_count = 0, reference_count = 0; // nodes or voxels; references to primitives, repeats counted
    // bvh only, by kType...: so few of a type that each ray is tested against them before its walk; they come first in their tables.
    std::array<std::uint32_t, 3> loose{};
    std::uint32_t depth = 0;
    double milliseconds = 0; // wall time of the build
    std::size_t bytes() const { return (nodes.size() + narrow.size()) * sizeof(gpu_layout::uvec4); }
};

// Puts the tables of `primitives` into the structure's order (their numbers stay with them); `corners` stay by number.
AccelTables build_accel(RayPrimitives& primitives, const AccelRequest& request);

// By kType...: how many of a type stay out of the tree of boxes, which are all of the type, or none.
std::array<std::uint32_t, 3> loose_types(const std::array<std::size_t, 3>& counts);

} // namespace lightbench
