// Clusters by meshoptimizer: triangles are halved along the longest axis into pieces that fit the cache, pieces are clustered in parallel.
#include "scene/clusters.h"

#include "scene/tessellate_faces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <meshoptimizer.h>
#include <numeric>
#include <thread>

namespace lightbench {
namespace {

using gpu_layout::PointPosition;
using Triangle = std::array<std::uint32_t, 3>;

// Few enough that a piece's vertices and the clusterer's tables stay in the second-level cache, many enough that the ragged clusters at a
// piece's rim do not count.
constexpr std::size_t kPieceTriangles = 16384;

// Between 0 (round clusters) and 1 (flat ones), as meshoptimizer recommends for culling by direction.
constexpr float kConeWeight = 0.5f;

struct Piece {
    std::uint32_t first, count;
};

// Halves at the median of the triangles' middles until pieces are small. Ties go by number, so the order is one and the same.
void halve(const std::vector<glm::vec3>& middles, std::vector<std::uint32_t>& order, Piece piece, std::vector<Piece>& pieces) {
    if (piece.count <= kPieceTriangles) return pieces.push_back(piece);
    const auto first = order.begin() + piece.first, last = first + piece.count, middle = first + piece.count / 2;
    glm::vec3 low = middles[*first], high = low;
    for (auto i = first; i != last; ++i) low = glm::min(low, middles[*i]), high = glm::max(high, middles[*i]);
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) {
        return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b;
    });
    std::sort(first, middle);
    std::sort(middle, last);
    halve(middles, order, {piece.first, piece.count / 2}, pieces);
    halve(middles, order, {piece.first + piece.count / 2, piece.count - piece.count / 2}, pieces);
}

// Clusters one piece at a time; its tables are kept from piece to piece.
class PieceClusterer {
  public:
    PieceClusterer(const std::vector<PointPosition>& vertices, const std::vector<Triangle>& triangles)
        : vertices_(vertices), triangles_(triangles), local_(vertices.size(), kNone) {}

    // Reorders the piece in place and returns the sizes of its clusters.
    std::vector<std::uint32_t> run(std::span<std::uint32_t> piece);

  private:
    void localize(std::span<const std::uint32_t> piece);
    std::uint32_t take(const Triangle& corners);

    const std::vector<PointPosition>& vertices_;
    const std::vector<Triangle>& triangles_;
    std::vector<std::uint32_t> local_; // of the scene's vertices: number within the piece
    std::vector<glm::vec3> positions_; // of the piece's vertices
    std::vector<std::uint32_t> globals_, indices_;
    std::vector<std::uint32_t> first_, next_; // chains of the piece's triangles by their lowest vertex
    std::vector<std::uint32_t> piece_;
};

void PieceClusterer::localize(std::span<const std::uint32_t> piece) {
    positions_.clear(), globals_.clear(), indices_.clear();
    for (std::uint32_t t : piece)
        for (std::uint32_t v : triangles_[t]) {
            if (local_[v] == kNone) {
                local_[v] = static_cast<std::uint32_t>(globals_.size());
                globals_.push_back(v);
                positions_.push_back(vertices_[v].position);
            }
            indices_.push_back(local_[v]);
        }
    for (std::uint32_t v : globals_) local_[v] = kNone;
    piece_.assign(piece.begin(), piece.end());
    first_.assign(globals_.size(), kNone), next_.resize(piece.size());
    for (std::size_t i = piece.size(); i-- > 0;) {
        std::uint32_t& head = first_[std::min({indices_[3 * i], indices_[3 * i + 1], indices_[3 * i + 2]})];
        next_[i] = head, head = static_cast<std::uint32_t>(i);
    }
}

// Finds, and takes out of its chain, a triangle of the piece by its corners, for a cluster forgets which triangles it was made of.
std::uint32_t PieceClusterer::take(const Triangle& c) {
    std::uint32_t* link = &first_[std::min({c[0], c[1], c[2]})];
    for (;; link = &next_[*link]) {
        const std::uint32_t* i = &indices_[3 * std::size_t(*link)];
        const bool same = (i[0] == c[0] && i[1] == c[1] && i[2] == c[2]) || (i[1] == c[0] && i[2] == c[1] && i[0] == c[2]) ||
                          (i[2] == c[0] && i[0] == c[1] && i[1] == c[2]);
        if (!same) continue;
        const std::uint32_t found = *link;
        *link = next_[found];
        return found;
    }
}

std::vector<std::uint32_t> PieceClusterer::run(std::span<std::uint32_t> piece) {
    localize(piece);
    std::vector<meshopt_Meshlet> meshlets(meshopt_buildMeshletsBound(indices_.size(), kMaxClusterVertices, kMaxClusterTriangles));
    std::vector<unsigned> vertices(meshlets.size() * kMaxClusterVertices);
    std::vector<unsigned char> corners(meshlets.size() * kMaxClusterTriangles * 3);
    meshlets.resize(meshopt_buildMeshlets(meshlets.data(), vertices.data(), corners.data(), indices_.data(), indices_.size(),
                                          &positions_[0].x, positions_.size(), sizeof(glm::vec3), kMaxClusterVertices, kMaxClusterTriangles,
                                          kConeWeight));
    std::vector<std::uint32_t> sizes;
    std::size_t at = 0;
    for (const meshopt_Meshlet& m : meshlets) {
        sizes.push_back(m.triangle_count);
        for (unsigned t = 0; t < m.triangle_count; ++t) {
            const unsigned char* c = &corners[m.triangle_offset + 3 * t];
            const unsigned* v = &vertices[m.vertex_offset];
            piece[at++] = piece_[take({v[c[0]], v[c[1]], v[c[2]]})];
        }
    }
    return sizes;
}

} // namespace

ClusterOrder cluster_order(const std::vector<PointPosition>& vertices, const std::vector<Triangle>& triangles) {
    ClusterOrder order;
    if (triangles.empty()) return order;
    order.triangles.resize(triangles.size());
    std::iota(order.triangles.begin(), order.triangles.end(), 0u);
    std::vector<Piece> pieces;
    {
        std::vector<glm::vec3> middles(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i)
            for (std::uint32_t v : triangles[i]) middles[i] += vertices[v].position;
        halve(middles, order.triangles, {0, static_cast<std::uint32_t>(triangles.size())}, pieces);
    }
    std::vector<std::vector<std::uint32_t>> sizes(pieces.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        PieceClusterer clusterer(vertices, triangles);
        for (std::size_t i; (i = next++) < pieces.size();) sizes[i] = clusterer.run({&order.triangles[pieces[i].first], pieces[i].count});
    };
    {
        std::vector<std::jthread> helpers;
        const std::size_t threads = std::min<std::size_t>({pieces.size(), std::max(1u, std::thread::hardware_concurrency()), 8});
        for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
        work();
    }
    for (const auto& s : sizes) order.sizes.insert(order.sizes.end(), s.begin(), s.end());
    return order;
}

namespace {

// meshoptimizer proposes centre and axis in float32; the radius and the spread are measured from them in double and rounded up.
double radius_about(const glm::dvec3& center, const std::vector<PointPosition>& vertices, std::span<const std::uint32_t> indices) {
    double square = 0;
    for (std::uint32_t v : indices) {
        const glm::dvec3 d = glm::dvec3(vertices[v].position) - center;
        square = std::max(square, glm::dot(d, d));
    }
    return std::sqrt(square);
}

// The sine of the largest angle between the axis and a face normal, or 1 if that is 80 degrees and more: then too little is culled.
// Float32 evaluation of the test errs by some 8 u = 2^-21 of the distance; twice that is added. Triangles without area do not count.
double cutoff_about(const glm::dvec3& axis, const std::vector<PointPosition>& vertices, std::span<const std::uint32_t> indices) {
    constexpr double kLeastCosine = 0.17, kRounding = 0x1p-20;
    double least = 1;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const glm::dvec3 a = vertices[indices[i]].position, b = vertices[indices[i + 1]].position, c = vertices[indices[i + 2]].position;
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        if (length > 0) least = std::min(least, glm::dot(normal, axis) / length);
    }
    return least < kLeastCosine ? 1 : std::sqrt(1 - least * least) + kRounding;
}

} // namespace

Cluster bound_cluster(const std::vector<PointPosition>& vertices, const std::vector<std::uint32_t>& indices, std::uint32_t first,
                      std::uint32_t count) {
    const std::span<const std::uint32_t> run{&indices[first], count};
    const meshopt_Bounds bounds =
        meshopt_computeClusterBounds(run.data(), count, &vertices[0].position.x, vertices.size(), sizeof(PointPosition));
    Cluster cluster{.first_index = first, .index_count = count};
    cluster.center = {bounds.center[0], bounds.center[1], bounds.center[2]};
    cluster.radius = std::nextafter(float(radius_about(cluster.center, vertices, run)), INFINITY);
    const glm::vec3 axis(bounds.cone_axis[0], bounds.cone_axis[1], bounds.cone_axis[2]);
    const double length = glm::length(glm::dvec3(axis));
    if (!(length > 0)) return cluster;
    const double cutoff = cutoff_about(glm::dvec3(axis) / length, vertices, run);
    if (cutoff < 1) cluster.cone_axis = glm::vec3(glm::dvec3(axis) / length), cluster.cone_cutoff = std::nextafter(float(cutoff), INFINITY);
    return cluster;
}

} // namespace lightbench
