// What the header of the same name says.
#include "radiosity/patch_units.h"

#include <numbers>
#include <numeric>

namespace lightbench {
namespace {

glm::dvec3 middle_of(const BaseMesh& base, const BaseFace& face) {
    glm::dvec3 sum(0);
    for (const Corner& c : base.loop(face)) sum += base.points[c.point];
    return sum / double(face.count);
}

class Gatherer {
  public:
    Gatherer(const BaseMesh& base, const BaseEdges& edges, const std::vector<std::uint32_t>& groups, double reach)
        : base_(base), edges_(edges), groups_(groups), reach_(reach), free_(base.faces.size()) {}
    void offer(std::uint32_t face) { free_[face] = true; }
    std::vector<std::uint32_t> around(std::uint32_t seed);

  private:
    bool joins(std::uint32_t f, std::uint32_t seed) const {
        return free_[f] && groups_[f] == groups_[seed] &&
               glm::dot(base_.faces[f].normal, base_.faces[seed].normal) >= 0.5 * std::numbers::sqrt2 &&
               glm::distance(middle_of(base_, base_.faces[f]), middle_of(base_, base_.faces[seed])) <= reach_;
    }

    const BaseMesh& base_;
    const BaseEdges& edges_;
    const std::vector<std::uint32_t>& groups_;
    const double reach_;
    std::vector<bool> free_;
};

// The faces of the patch about a free face, which are free no more.
std::vector<std::uint32_t> Gatherer::around(std::uint32_t seed) {
    std::vector<std::uint32_t> found;
    if (!free_[seed]) return found;
    found.push_back(seed);
    free_[seed] = false;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const BaseFace& face = base_.faces[found[i]];
        for (std::uint32_t c = face.first; c < face.first + face.count; ++c) {
            const auto users = edges_.users_of(edges_.of_corner[c]);
            if (users.size() != 2) continue; // as in smooth_groups
            const std::uint32_t next = edges_.face_of_corner[users[0] == c ? users[1] : users[0]];
            if (!joins(next, seed)) continue;
            free_[next] = false;
            found.push_back(next);
        }
    }
    return found;
}

} // namespace

std::vector<std::uint32_t> gather_units(const BaseMesh& base, const BaseEdges& edges, const std::vector<Unit>& units,
                                        const std::vector<std::uint32_t>& groups, double patch) {
    std::vector<std::uint32_t> unit_of_face(base.faces.size(), kNone), patches(units.size());
    std::iota(patches.begin(), patches.end(), 0u);
    Gatherer gatherer(base, edges, groups, patch / 2);
    for (std::uint32_t u = 0; u < units.size(); ++u)
        if (units[u].whole) unit_of_face[units[u].face] = u, gatherer.offer(units[u].face);
    for (std::uint32_t u = 0; u < units.size(); ++u)
        for (std::uint32_t face : gatherer.around(units[u].face)) patches[unit_of_face[face]] = u;
    return patches;
}

} // namespace lightbench
