// Merges equal vertices by meshoptimizer's hash. In: streams and triangles. Out: the same with fewer vertices.
#include "scene/tessellate_merge.h"

#include <meshoptimizer.h>

namespace lightbench {
namespace {

struct Whole {
    glm::vec3 position{0};
    gpu_layout::PointNormal normal{};
};
struct WholeWithDetail {
    Whole whole;
    gpu_layout::PointDetail detail{};
};
static_assert(sizeof(Whole) == 28 && sizeof(WholeWithDetail) == 76, "hashed as bytes, so without padding");

std::vector<Whole> whole_vertices(const PointStreams& vertices) {
    std::vector<Whole> whole(vertices.positions.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        whole[i].position = vertices.positions[i].position;
        if (!vertices.normals.empty()) whole[i].normal = vertices.normals[i];
    }
    return whole;
}

template <typename T> std::size_t find_equal(std::vector<unsigned>& merged, const std::vector<T>& whole) {
    return meshopt_generateVertexRemap(merged.data(), nullptr, whole.size(), whole.data(), whole.size(), sizeof(T));
}

std::size_t find_equal(std::vector<unsigned>& merged, const PointStreams& vertices) {
    const auto whole = whole_vertices(vertices);
    if (vertices.detail.empty()) return find_equal(merged, whole);
    std::vector<WholeWithDetail> detailed(whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) detailed[i] = {whole[i], vertices.detail[i]};
    return find_equal(merged, detailed);
}

} // namespace

void merge_vertices(RasterGeometry& geometry, Soups& soups) {
    auto& [positions, normals, detail] = geometry.vertices;
    if (positions.empty()) return;
    std::vector<unsigned> merged(positions.size());
    const std::size_t count = find_equal(merged, geometry.vertices);
    for (Soup& soup : soups)
        for (auto& triangle : soup.triangles)
            for (auto& v : triangle) v = merged[v];
    for (std::size_t i = 0; i < merged.size(); ++i) { // first uses keep their order, so nothing is overwritten before it is read
        positions[merged[i]] = positions[i];
        if (!normals.empty()) normals[merged[i]] = normals[i];
        if (!detail.empty()) detail[merged[i]] = detail[i];
    }
    positions.resize(count);
    if (!normals.empty()) normals.resize(count);
    if (!detail.empty()) detail.resize(count);
}

} // namespace lightbench
