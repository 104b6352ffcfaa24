// Culling by bounding sphere and normal cone. Vertex work is single-threaded on CPU drivers, so what is not drawn is what is won.
#include "render/cull.h"

#include <array>

namespace lightbench {
namespace {

using Planes = std::array<glm::dvec4, 5>;

// Gribb and Hartmann 2001, "Fast Extraction of Viewing Frustum Planes": left, right, top, bottom, near; unit normals pointing inwards.
Planes frustum_planes(const glm::mat4& clip_from_frame) {
    const glm::dmat4 rows = glm::transpose(glm::dmat4(clip_from_frame));
    Planes planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3] - rows[2]};
    for (auto& p : planes) p /= glm::length(glm::dvec3(p));
    return planes;
}

// Frame coordinates are below 2 and rounded to float (2^-24 each), the sphere's radius and the matrix likewise: 2^-20 covers their sum,
// and the driver's snap of vertices to 1/256 pixel stays inside the pixel that the plane already includes.
constexpr double kMargin = 0x1p-20;

bool outside(const Planes& planes, const Cluster& cluster) {
    for (const auto& p : planes)
        if (glm::dot(glm::dvec3(p), glm::dvec3(cluster.center)) + p.w < -(double(cluster.radius) + kMargin)) return true;
    return false;
}

bool faces_away(const Cluster& cluster, glm::dvec3 eye) {
    if (cluster.two_sided || cluster.cone_cutoff >= 1) return false;
    const glm::dvec3 to_cluster = glm::dvec3(cluster.center) - eye;
    return glm::dot(to_cluster, glm::dvec3(cluster.cone_axis)) >=
           double(cluster.cone_cutoff) * glm::length(to_cluster) + double(cluster.radius) + kMargin;
}

} // namespace

std::vector<IndexRun> visible_runs(std::span<const Cluster> clusters, const glm::mat4& clip_from_frame, glm::vec3 eye) {
    const Planes planes = frustum_planes(clip_from_frame);
    std::vector<IndexRun> runs;
    for (const Cluster& c : clusters) {
        if (outside(planes, c) || faces_away(c, glm::dvec3(eye))) continue;
        if (!runs.empty() && runs.back().first + runs.back().count == c.first_index)
            runs.back().count += c.index_count;
        else
            runs.push_back({c.first_index, c.index_count});
    }
    return runs;
}

} // namespace lightbench
