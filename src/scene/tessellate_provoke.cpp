// Provoking vertices: a vertex can carry one polygon only, so a triangle whose corners are all taken gets a copy of one.
// A mesh of triangles has twice as many polygons as vertices, and comes out with about as many vertices as polygons: no fewer would do.
#include "scene/tessellate_provoke.h"

#include "scene/clusters.h"
#include "scene/tessellate_faces.h"

namespace lightbench {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Orderer {
  public:
    Orderer(RasterGeometry& geometry, std::size_t triangles);
    void add(Soup& soup, bool two_sided);
    void finish();

  private:
    std::uint32_t vertex(std::uint32_t old);
    std::uint32_t copy(std::uint32_t old, std::uint32_t polygon);
    bool is_free(std::uint32_t old) const { return renumbered_[old] == kNone || taken_[renumbered_[old]] == kNone; }
    Triangle provoked(const Triangle& old, std::uint32_t polygon);
    Triangle from(const Triangle& old, std::size_t first, std::uint32_t provoking);

    RasterGeometry& geometry_;
    PointStreams made_;
    std::vector<std::uint32_t> renumbered_; // of old vertices: their number now, kNone if not used yet
    std::vector<std::uint32_t> taken_;      // of new vertices: the polygon that they provoke
    struct Provoker {
        std::uint32_t old = kNone, made = kNone;
    };
    std::vector<Provoker> provokers_; // of polygons: the last vertex that provoked them
};

Orderer::Orderer(RasterGeometry& geometry, std::size_t triangles)
    : geometry_(geometry), renumbered_(geometry.vertices.positions.size(), kNone), provokers_(geometry.polygons.positions.size()) {
    geometry_.indices.reserve(3 * triangles);
    made_.positions.reserve(renumbered_.size());
    made_.normals.reserve(geometry_.vertices.normals.size());
    made_.detail.reserve(geometry_.vertices.detail.size());
}

std::uint32_t Orderer::copy(std::uint32_t old, std::uint32_t polygon) {
    gpu_layout::PointPosition position = geometry_.vertices.positions[old];
    position.polygon = polygon == kNone ? 0 : polygon;
    made_.positions.push_back(position);
    if (!geometry_.vertices.normals.empty()) made_.normals.push_back(geometry_.vertices.normals[old]);
    if (!geometry_.vertices.detail.empty()) made_.detail.push_back(geometry_.vertices.detail[old]);
    taken_.push_back(polygon);
    return static_cast<std::uint32_t>(taken_.size() - 1);
}

std::uint32_t Orderer::vertex(std::uint32_t old) {
    if (renumbered_[old] == kNone) renumbered_[old] = copy(old, kNone);
    return renumbered_[old];
}

Triangle Orderer::from(const Triangle& old, std::size_t first, std::uint32_t provoking) {
    return {provoking, vertex(old[(first + 1) % 3]), vertex(old[(first + 2) % 3])};
}

// First choice: the vertex that provokes the polygon already; then a corner that is free, the common one of a fan before others; else a copy.
Triangle Orderer::provoked(const Triangle& old, std::uint32_t polygon) {
    Provoker& provoker = provokers_[polygon];
    for (std::size_t i = 0; i < 3; ++i)
        if (old[i] == provoker.old) return from(old, i, provoker.made);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!is_free(old[i])) continue;
        const std::uint32_t made = vertex(old[i]);
        taken_[made] = made_.positions[made].polygon = polygon;
        provoker = {old[i], made};
        return from(old, i, made);
    }
    provoker = {old[0], copy(old[0], polygon)};
    return from(old, 0, provoker.made);
}

void Orderer::add(Soup& soup, bool two_sided) {
    const ClusterOrder order = cluster_order(geometry_.vertices.positions, soup.triangles);
    std::size_t next = 0;
    for (std::uint32_t size : order.sizes) {
        geometry_.clusters.push_back(
            {.first_index = static_cast<std::uint32_t>(geometry_.indices.size()), .index_count = 3 * size, .two_sided = two_sided});
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t t = order.triangles[next++];
            const Triangle& old = soup.triangles[t];
            const Triangle made = soup.polygons.empty() ? from(old, 0, vertex(old[0])) : provoked(old, soup.polygons[t]);
            geometry_.indices.insert(geometry_.indices.end(), made.begin(), made.end());
        }
    }
    soup = {};
}

void Orderer::finish() {
    geometry_.vertices = std::move(made_);
    for (Cluster& c : geometry_.clusters) {
        const bool two_sided = c.two_sided;
        c = bound_cluster(geometry_.vertices.positions, geometry_.indices, c.first_index, c.index_count);
        c.two_sided = two_sided;
    }
}

} // namespace

void order_triangles(RasterGeometry& geometry, Soups& soups) {
    std::size_t triangles = 0;
    for (const Soup& soup : soups) triangles += soup.triangles.size();
    Orderer orderer(geometry, triangles);
    orderer.add(soups[soup_of(false, false)], false);
    geometry.one_sided_clusters = geometry.clusters.size();
    orderer.add(soups[soup_of(false, true)], true);
    geometry.opaque_clusters = geometry.clusters.size();
    orderer.add(soups[soup_of(true, false)], false);
    geometry.translucent_one_sided_clusters = geometry.clusters.size() - geometry.opaque_clusters;
    orderer.add(soups[soup_of(true, true)], true);
    orderer.finish();
}

} // namespace lightbench
