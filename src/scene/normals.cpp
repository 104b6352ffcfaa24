// Newell's face normals, angle-weighted vertex normals in groups that creases bound, and the guard against normals that vanish.
#include "scene/normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lightbench {
namespace {

// A corner seen from its point: the face it belongs to and where its two edges lead.
struct Around {
    std::uint32_t corner, face, before, after;
};

// An edge that leaves the point, and the corner (of those around the point) that it bounds.
struct Edge {
    std::uint32_t to, around;
    auto operator<=>(const Edge&) const = default;
};

// Corners by point: corners_of(p) are by_point[starts[p]] ... by_point[starts[p + 1] - 1].
struct CornersByPoint {
    std::vector<std::uint32_t> starts;
    std::vector<Around> by_point;
};

CornersByPoint corners_by_point(const Faces& faces) {
    CornersByPoint sorted;
    sorted.starts.assign(faces.points.size() + 1, 0);
    for (const Corner& c : faces.corners) ++sorted.starts[c.point + 1];
    std::partial_sum(sorted.starts.begin(), sorted.starts.end(), sorted.starts.begin());
    sorted.by_point.resize(faces.corners.size());
    std::vector<std::uint32_t> next(sorted.starts.begin(), sorted.starts.end() - 1);
    for (std::uint32_t face = 0; face < faces.count(); ++face) {
        const auto loop = faces.loop(face);
        for (std::size_t i = 0, n = loop.size(); i < n; ++i)
            sorted.by_point[next[loop[i].point]++] = {static_cast<std::uint32_t>(faces.starts[face] + i), face, loop[(i + n - 1) % n].point,
                                                      loop[(i + 1) % n].point};
    }
    return sorted;
}

// An edge that more faces share is a seam of sheets, not a surface: it stays sharp. The bound keeps the pairs few.
constexpr std::size_t kMaxFacesAnEdge = 8;

// Smooths around one point at a time; its vectors are kept from point to point.
class PointSmoother {
  public:
    PointSmoother(Faces& faces, const std::vector<glm::dvec3>& of_faces, double crease)
        : faces_(faces), of_faces_(of_faces), least_cosine_(crease >= std::numbers::pi ? -2.0 : std::cos(crease)) {}

    void smooth(std::uint32_t point, std::span<const Around> around);

  private:
    std::uint32_t root(std::uint32_t i) {
        while (group_[i] != i) i = group_[i] = group_[group_[i]];
        return i;
    }
    void find_groups(std::span<const Around> around);
    void join(std::span<const Around> around, std::span<const Edge> same);

    Faces& faces_;
    const std::vector<glm::dvec3>& of_faces_;
    const double least_cosine_;
    std::vector<std::uint32_t> group_, normal_;
    std::vector<Edge> edges_;
    std::vector<glm::dvec3> sum_;
};

void PointSmoother::join(std::span<const Around> around, std::span<const Edge> same) {
    if (same.size() > kMaxFacesAnEdge) return;
    for (std::size_t i = 0; i < same.size(); ++i)
        for (std::size_t j = i + 1; j < same.size(); ++j) {
            const auto& a = of_faces_[around[same[i].around].face];
            const auto& b = of_faces_[around[same[j].around].face];
            if (glm::dot(a, b) > least_cosine_) group_[root(same[j].around)] = root(same[i].around);
        }
}

void PointSmoother::find_groups(std::span<const Around> around) {
    group_.resize(around.size());
    std::iota(group_.begin(), group_.end(), 0u);
    edges_.clear();
    for (std::uint32_t i = 0; i < around.size(); ++i) {
        edges_.push_back({around[i].before, i});
        edges_.push_back({around[i].after, i});
    }
    std::sort(edges_.begin(), edges_.end());
    for (auto first = edges_.begin(); first != edges_.end();) {
        const auto last = std::find_if(first, edges_.end(), [&](const Edge& e) { return e.to != first->to; });
        join(around, {first, last});
        first = last;
    }
}

// Thuermer and Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets": weights are angles, so no triangulation matters.
void PointSmoother::smooth(std::uint32_t point, std::span<const Around> around) {
    find_groups(around);
    sum_.assign(around.size(), glm::dvec3(0));
    normal_.assign(around.size(), kNone);
    for (std::uint32_t i = 0; i < around.size(); ++i) {
        const glm::dvec3& normal = of_faces_[around[i].face];
        const glm::dvec3 &here = faces_.points[point], &after = faces_.points[around[i].after], &before = faces_.points[around[i].before];
        sum_[root(i)] += corner_angle(after - here, before - here, normal) * normal;
    }
    for (std::uint32_t i = 0; i < around.size(); ++i) {
        Corner& corner = faces_.corners[around[i].corner];
        if (corner.normal != kNone) continue;
        const std::uint32_t group = root(i);
        if (normal_[group] == kNone) {
            normal_[group] = static_cast<std::uint32_t>(faces_.normals.size());
            const double length = glm::length(sum_[group]);
            faces_.normals.push_back(length > 0 ? sum_[group] / length : glm::dvec3(0));
        }
        corner.normal = normal_[group];
    }
}

} // namespace

// atan2 is exact to a few u at 0 and pi, where acos loses half the digits.
double corner_angle(const glm::dvec3& to_next, const glm::dvec3& to_previous, const glm::dvec3& normal) {
    const glm::dvec3 cross = glm::cross(to_next, to_previous);
    const double angle = std::atan2(glm::length(cross), glm::dot(to_next, to_previous));
    return glm::dot(cross, normal) < 0 ? 2 * std::numbers::pi - angle : angle;
}

// Newell's sum (Sutherland, Sproull, Schumacker 1974) about the first corner: differences of float32 points are exact in double. Each product of
// two edges carries at most 4 u of its size; a sum that is not above that is no area.
glm::dvec3 face_normal(const std::vector<glm::dvec3>& points, std::span<const Corner> loop) {
    const glm::dvec3 origin = points[loop[0].point];
    glm::dvec3 sum(0), a = points[loop[1].point] - origin;
    double products = 0;
    for (std::size_t i = 2; i < loop.size(); ++i) {
        const glm::dvec3 b = points[loop[i].point] - origin;
        sum += glm::cross(a, b);
        products += std::sqrt(glm::dot(a, a) * glm::dot(b, b));
        a = b;
    }
    const double length = glm::length(sum);
    return length > 0x1p-51 * products ? sum / length : glm::dvec3(0);
}

std::vector<glm::dvec3> face_normals(const Faces& faces) {
    std::vector<glm::dvec3> normals(faces.count());
    for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = face_normal(faces.points, faces.loop(i));
    return normals;
}

void smooth_normals(Faces& faces, const std::vector<glm::dvec3>& of_faces, double crease) {
    const CornersByPoint sorted = corners_by_point(faces);
    PointSmoother smoother(faces, of_faces, crease);
    for (std::uint32_t p = 0; p < faces.points.size(); ++p)
        smoother.smooth(p, {sorted.by_point.data() + sorted.starts[p], sorted.starts[p + 1] - sorted.starts[p]});
}

void face_outwards(Faces& faces, const std::vector<glm::dvec3>& of_faces, const std::vector<bool>& kept) {
    for (std::size_t f = 0; f < faces.count(); ++f)
        for (Corner& corner : faces.loop(f)) {
            if (!kept.empty() && corner.normal < kept.size() && kept[corner.normal]) continue;
            if (glm::dot(faces.normals[corner.normal], of_faces[f]) > kMinFacing) continue;
            corner.normal = static_cast<std::uint32_t>(faces.normals.size());
            faces.normals.push_back(of_faces[f]);
        }
}

bool all_on_one_side(const Faces& faces, const std::vector<glm::dvec3>& of_faces) {
    for (std::size_t f = 0; f < faces.count(); ++f) {
        bool before = true, behind = true;
        for (const Corner& corner : faces.loop(f)) {
            const double facing = glm::dot(faces.normals[corner.normal], of_faces[f]);
            before = before && facing > kMinFacing;
            behind = behind && facing < -kMinFacing;
        }
        if (!before && !behind) return false;
    }
    return true;
}

} // namespace lightbench
