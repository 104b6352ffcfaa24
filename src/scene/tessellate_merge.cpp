// Merges equal vertices by meshoptimizer's hash. In: streams and triangles. Out: the same with fewer vertices.
#include "scene/tessellate_merge.h"

#include <meshoptimizer.h>

namespace lightbench {
namespace {

struct Whole {
    glm::vec3 position{0};
    gpu_layout::PointNormal normal{};
};
static_assert(sizeof(Whole) == 28, "hashed as bytes, so without padding");

std::vector<Whole> whole_vertices(const PointStreams& vertices) {
    std::vector<Whole> whole(vertices.positions.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        whole[i].position = vertices.positions[i].position;
        if (!vertices.normals.empty()) whole[i].normal = vertices.normals[i];
    }
    return whole;
}

} // namespace

void merge_vertices(RasterGeometry& geometry, Soup& one_sided, Soup& two_sided) {
    auto& [positions, normals] = geometry.vertices;
    if (positions.empty()) return;
    std::vector<unsigned> merged(positions.size());
    const auto whole = whole_vertices(geometry.vertices);
    const std::size_t count = meshopt_generateVertexRemap(merged.data(), nullptr, whole.size(), whole.data(), whole.size(), sizeof(Whole));
    for (Soup* soup : {&one_sided, &two_sided})
        for (auto& triangle : soup->triangles)
            for (auto& v : triangle) v = merged[v];
    for (std::size_t i = 0; i < merged.size(); ++i) { // first uses keep their order, so nothing is overwritten before it is read
        positions[merged[i]] = positions[i];
        if (!normals.empty()) normals[merged[i]] = normals[i];
    }
    positions.resize(count);
    if (!normals.empty()) normals.resize(count);
}

} // namespace lightbench
