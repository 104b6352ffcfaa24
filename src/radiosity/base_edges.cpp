// Edges of the welded faces, and the smooth groups that they bound. Declared in base_faces.h.
#include "radiosity/base_faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lightbench {
namespace {

struct Use {
    std::uint64_t key; // lower point, higher point
    std::uint32_t corner;
    auto operator<=>(const Use&) const = default;
};

std::vector<Use> sorted_uses(const BaseMesh& base) {
    std::vector<Use> uses(base.corners.size());
    for (const BaseFace& face : base.faces)
        for (std::uint32_t i = 0; i < face.count; ++i) {
            const std::uint32_t a = base.corners[face.first + i].point, b = base.corners[face.first + (i + 1) % face.count].point;
            uses[face.first + i] = {(std::uint64_t{std::min(a, b)} << 32) | std::max(a, b), face.first + i};
        }
    std::sort(uses.begin(), uses.end());
    return uses;
}

bool share_a_normal(const BaseMesh& base, const BaseEdges& edges, std::uint32_t a, std::uint32_t b) {
    const auto normal = [&](std::uint32_t corner) { return base.normals[base.corners[corner].normal]; };
    const std::uint32_t after_a = next_corner(base, edges, a), after_b = next_corner(base, edges, b);
    return normal(a) == normal(after_b) || normal(b) == normal(after_a); // neighbours run along an edge in opposite ways
}

bool smooth(const BaseMesh& base, const BaseEdges& edges, std::uint32_t a, std::uint32_t b) {
    const BaseFace &f = base.faces[edges.face_of_corner[a]], &g = base.faces[edges.face_of_corner[b]];
    if (f.surface != g.surface || base.corners[a].point == base.corners[b].point) return false;
    if (f.object == g.object) return share_a_normal(base, edges, a, b);
    return glm::dot(f.normal, g.normal) > std::cos(double(std::min(f.crease, g.crease)));
}

} // namespace

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

std::uint32_t next_corner(const BaseMesh& base, const BaseEdges& edges, std::uint32_t corner) {
    const BaseFace& face = base.faces[edges.face_of_corner[corner]];
    return corner + 1 < face.first + face.count ? corner + 1 : face.first;
}

BaseEdges edges_of(const BaseMesh& base) {
    BaseEdges edges;
    const auto uses = sorted_uses(base);
    edges.of_corner.resize(uses.size());
    edges.users.resize(uses.size());
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
        if (i == 0 || uses[i].key != uses[i - 1].key) {
            edges.starts.push_back(i);
            edges.ends.push_back({static_cast<std::uint32_t>(uses[i].key >> 32), static_cast<std::uint32_t>(uses[i].key)});
        }
        edges.users[i] = uses[i].corner;
        edges.of_corner[uses[i].corner] = static_cast<std::uint32_t>(edges.ends.size() - 1);
    }
    edges.starts.push_back(static_cast<std::uint32_t>(uses.size()));
    for (std::uint32_t f = 0; f < base.faces.size(); ++f) edges.face_of_corner.insert(edges.face_of_corner.end(), base.faces[f].count, f);
    return edges;
}

std::vector<std::uint32_t> smooth_groups(const BaseMesh& base, const BaseEdges& edges) {
    std::vector<std::uint32_t> group(base.faces.size());
    std::iota(group.begin(), group.end(), 0u);
    for (std::uint32_t e = 0; e < edges.count(); ++e) {
        const auto users = edges.users_of(e);
        if (users.size() != 2 || !smooth(base, edges, users[0], users[1])) continue;
        const std::uint32_t a = root_of(group, edges.face_of_corner[users[0]]), b = root_of(group, edges.face_of_corner[users[1]]);
        group[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t f = 0; f < group.size(); ++f) group[f] = root_of(group, f);
    return group;
}

} // namespace lightbench
