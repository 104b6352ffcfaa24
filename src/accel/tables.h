// From the binary tree to the tables that shaders read. In: Tree, or boxes. Out: texels, and what goes with them in AccelTables.
#pragma once

#include "accel/accel.h"
#include "accel/tree.h"

namespace lightbench {

// References to the primitives of a tree's leaves, in the order in which the tables hold them.
class LeafReferences {
  public:
    // `before`: how many of each type lie before them in their tables.
    LeafReferences(const Tree& tree, const std::array<std::uint32_t, 3>& before);
    std::uint32_t of(const TreeNode& leaf) const;

  private:
    std::vector<std::uint32_t> index_; // of each item in the table of its type
    const Tree& tree_;
};

// Inner nodes in the order of a walk that goes left first.
std::vector<std::uint32_t> inner_numbers(const Tree& tree);

// Both set AccelTables::stack to what their walk needs, if that is more than it says.
void add_wide(AccelTables& tables, const Tree& tree);
void add_narrow(AccelTables& tables, const Tree& tree);

// `spheres` by slot.
void add_spheres(AccelTables& tables, const Tree& tree, const std::vector<glm::vec4>& spheres);

// Sets where the planes of a narrow tree over `box` lie. Returns by how many frame units they must lie outside of what they bound.
double set_planes(AccelTables& tables, const FloatBox& box);

// Where plane q of the narrow tree lies, in exact arithmetic.
inline double narrow_plane(const AccelTables& tables, int axis, std::uint32_t q) {
    return double{tables.narrow_origin[axis]} + double{tables.narrow_step[axis]} * q;
}

} // namespace lightbench
