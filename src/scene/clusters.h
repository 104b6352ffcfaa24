// Groups triangles that are near each other and face the same way, and bounds each group. In: positions and triangles. Out: an order of
// the triangles, the sizes of the groups in it, their bounding spheres and normal cones.
#pragma once

#include "scene/tessellate.h"

#include <array>

namespace lightbench {

constexpr std::size_t kMaxClusterTriangles = 128, kMaxClusterVertices = 192;

struct ClusterOrder {
    std::vector<std::uint32_t> triangles; // a permutation
    std::vector<std::uint32_t> sizes;     // triangles of each cluster, in that order
};

// The same for the same input, however many threads the machine has.
ClusterOrder cluster_order(const std::vector<gpu_layout::PointPosition>& vertices,
                           const std::vector<std::array<std::uint32_t, 3>>& triangles);

// Sphere and cone of a run of indices; both hold for the float32 positions that are drawn.
Cluster bound_cluster(const std::vector<gpu_layout::PointPosition>& vertices, const std::vector<std::uint32_t>& indices,
                      std::uint32_t first, std::uint32_t count);

} // namespace lightbench
