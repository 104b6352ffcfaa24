// BVH of spheres: the tree of boxes, each node's contents in a sphere instead (shaders/shared/rays.h: kSphereNodeTexels).
// In: Tree, a sphere about each primitive. Out: AccelTables::nodes.
#include "accel/tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace lightbench {
namespace {

using gpu_layout::uvec4;

struct Ball {
    glm::vec3 center{0};
    double radius = 0;
};

// The least radius about `center` that holds all of them; rounded by 1e-15, so 2^-48 of it is added.
double radius_about(const glm::vec3& center, std::span<const TreeItem> items, const std::vector<glm::vec4>& spheres) {
    double radius = 0;
    for (const TreeItem& item : items) {
        const glm::vec4& s = spheres[item.slot];
        radius = std::max(radius, glm::length(glm::dvec3(s) - glm::dvec3(center)) + double{s.w});
    }
    return radius * (1 + 0x1p-48);
}

// Of the mean of the box and the middle of the two children's spheres, the better.
class Balls {
  public:
    Balls(const Tree& tree, const std::vector<glm::vec4>& spheres) : balls_(tree.nodes.size()), tree_(tree), spheres_(spheres) {}

    const Ball& of(std::uint32_t node) const { return balls_[node]; }

    void make(std::uint32_t n, std::span<const TreeItem> items) {
        const TreeNode& node = tree_.nodes[n];
        balls_[n] = about(0.5f * node.box.min + 0.5f * node.box.max, items);
        if (items.size() == 1) balls_[n] = about(glm::vec3(spheres_[items[0].slot]), items);
        if (node.count > 0) return;
        const Ball other = about(middle(balls_[node.first], balls_[node.first + 1]), items);
        if (other.radius < balls_[n].radius) balls_[n] = other;
    }

  private:
    Ball about(const glm::vec3& center, std::span<const TreeItem> items) const { return {center, radius_about(center, items, spheres_)}; }

    // Of the smallest sphere about two.
    static glm::vec3 middle(const Ball& a, const Ball& b) {
        const glm::dvec3 to = glm::dvec3(b.center) - glm::dvec3(a.center);
        const double distance = glm::length(to);
        if (!(distance > std::abs(a.radius - b.radius))) return a.radius > b.radius ? a.center : b.center;
        return glm::vec3(glm::dvec3(a.center) + 0.5 * (1 + (b.radius - a.radius) / distance) * to);
    }

    std::vector<Ball> balls_;
    const Tree& tree_;
    const std::vector<glm::vec4>& spheres_;
};

float above(double x) {
    const auto f = static_cast<float>(x);
    return f >= x ? f : std::nextafter(f, INFINITY);
}

uvec4 words_of(const Ball& ball) {
    return {std::bit_cast<std::uint32_t>(ball.center.x), std::bit_cast<std::uint32_t>(ball.center.y),
            std::bit_cast<std::uint32_t>(ball.center.z), std::bit_cast<std::uint32_t>(above(ball.radius))};
}

// Items below each node, from its leaves up: children come after their parents.
std::vector<std::span<const TreeItem>> items_below(const Tree& tree) {
    std::vector<std::span<const TreeItem>> below(tree.nodes.size());
    for (std::size_t n = tree.nodes.size(); n-- > 0;) {
        const TreeNode& node = tree.nodes[n];
        if (node.count > 0)
            below[n] = std::span(tree.items).subspan(node.first, node.count);
        else
            below[n] = {below[node.first].data(), below[node.first].size() + below[node.first + 1].size()};
    }
    return below;
}

constexpr float kAbsentRadius = -1;

} // namespace

void add_spheres(AccelTables& tables, const Tree& tree, const std::vector<glm::vec4>& spheres) {
    using namespace gpu_layout;
    tables.stack = tree.depth + 2; // as of the tree of boxes
    const uvec4 absent(0, 0, 0, std::bit_cast<std::uint32_t>(kAbsentRadius));
    tables.nodes = {absent, absent, {kNothing, kNothing, 0, 0}};
    if (tree.nodes.empty()) return;
    const LeafReferences references(tree, tables.loose);
    const auto below = items_below(tree);
    Balls balls(tree, spheres);
    for (std::size_t n = tree.nodes.size(); n-- > 0;) balls.make(static_cast<std::uint32_t>(n), below[n]);
    if (tree.nodes[0].count > 0) {
        tables.nodes[0] = words_of(balls.of(0));
        tables.nodes[2].x = references.of(tree.nodes[0]);
        return;
    }
    const auto numbers = inner_numbers(tree);
    tables.nodes.resize(kSphereNodeTexels * (tree.nodes.size() / 2));
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        if (tree.nodes[n].count > 0) continue;
        const std::size_t at = kSphereNodeTexels * std::size_t{numbers[n]};
        for (std::uint32_t i = 0; i < 2; ++i) {
            const std::uint32_t c = tree.nodes[n].first + i;
            tables.nodes[at + i] = words_of(balls.of(c));
            tables.nodes[at + 2][static_cast<int>(i)] = tree.nodes[c].count > 0 ? references.of(tree.nodes[c]) : numbers[c];
        }
    }
}

} // namespace lightbench
