// The tree with two children a node and 16-bit planes (shaders/shared/rays.h: kNarrowTexels). In: Tree. Out: AccelTables::narrow.
#include "accel/tables.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

using gpu_layout::uvec4;

constexpr double kLargest = 65535;

// How far outside its plane a shader may find it: origin - o + q * step, folded into the ray or not, is rounded some four times by 2^-24 of
// numbers up to 6 times `size` (accel/boxes.cpp), which is 2^-19.4.
constexpr double kMargin = 0x1p-19;

class Planes {
  public:
    Planes(AccelTables& tables, const FloatBox& box) : tables_(tables), margin_(set_planes(tables, box)) {}

    std::uint32_t below(int axis, double x) const { return static_cast<std::uint32_t>(clamped(std::floor(at(axis, x - margin_)))); }
    std::uint32_t above(int axis, double x) const { return static_cast<std::uint32_t>(clamped(std::ceil(at(axis, x + margin_)))); }

    uvec4 words(const FloatBox& box, std::uint32_t reference) const {
        uvec4 words(0, 0, 0, reference);
        for (int axis = 0; axis < 3; ++axis) words[axis] = below(axis, box.min[axis]) | above(axis, box.max[axis]) << 16;
        return words;
    }

    double half_area(const uvec4& words) const {
        glm::dvec3 d;
        for (int axis = 0; axis < 3; ++axis) d[axis] = double{tables_.narrow_step[axis]} * ((words[axis] >> 16) - (words[axis] & 0xffffu));
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }

  private:
    double at(int axis, double x) const { return (x - tables_.narrow_origin[axis]) / tables_.narrow_step[axis]; }
    static double clamped(double q) { return q > 0 ? std::min(q, kLargest) : 0; } // also of NaN

    AccelTables& tables_;
    double margin_;
};

constexpr uvec4 kAbsent{0xffffu, 0xffffu, 0xffffu, gpu_layout::kNothing}; // lo 65535, hi 0

struct Cost {
    double exact = 0, narrow = 0;
    void add(double exact_area, double narrow_area, double tests) { exact += exact_area * tests, narrow += narrow_area * tests; }
};

} // namespace

double set_planes(AccelTables& tables, const FloatBox& box) {
    const glm::dvec3 min(box.min), max(box.max);
    double size = 0;
    for (int axis = 0; axis < 3; ++axis) size = std::max({size, std::abs(min[axis]), std::abs(max[axis])});
    for (int axis = 0; axis < 3; ++axis) {
        const double margin = std::max(2 * kMargin * size, 0x1p-100);
        tables.narrow_origin[axis] = std::nextafter(static_cast<float>(min[axis] - margin), -INFINITY);
        const double extent = max[axis] + margin - tables.narrow_origin[axis];
        tables.narrow_step[axis] = std::nextafter(static_cast<float>(extent / kLargest), INFINITY);
    }
    return kMargin * size;
}

void add_narrow(AccelTables& tables, const Tree& tree) {
    tables.stack = std::max(tables.stack, tree.depth + 2); // as the wide one
    tables.narrow.assign(2, kAbsent);
    if (tree.nodes.empty()) return;
    const LeafReferences references(tree, tables.loose);
    const Planes planes(tables, tree.nodes[0].box);
    if (tree.nodes[0].count > 0) return void(tables.narrow[0] = planes.words(tree.nodes[0].box, references.of(tree.nodes[0])));
    const auto numbers = inner_numbers(tree);
    tables.narrow.resize(tree.nodes.size() - 1); // two texels an inner node, and a tree has one leaf more than inner nodes
    Cost cost;
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        if (tree.nodes[n].count > 0) continue;
        for (std::uint32_t i = 0; i < 2; ++i) {
            const std::uint32_t c = tree.nodes[n].first + i;
            const TreeNode& child = tree.nodes[c];
            const uvec4 words = planes.words(child.box, child.count > 0 ? references.of(child) : numbers[c]);
            tables.narrow[2 * std::size_t{numbers[n]} + i] = words;
            cost.add(half_area(child.box), planes.half_area(words), child.count > 0 ? child.count : kOpenCost);
        }
    }
    if (cost.exact > 0) tables.narrow_inflation = cost.narrow / cost.exact;
}

} // namespace lightbench
