// BVH of boxes: one binary tree, written wide and narrow. In: items of the scene. Out: tables, and the order of the primitives.
#include "accel/tables.h"

namespace lightbench {

LeafReferences::LeafReferences(const Tree& tree) : tree_(tree) {
    std::array<std::uint32_t, 3> next{};
    index_.reserve(tree.items.size());
    for (const TreeItem& item : tree.items) index_.push_back(next[item.type]++);
}

std::uint32_t LeafReferences::of(const TreeNode& leaf) const {
    using namespace gpu_layout;
    return kRefLeaf | tree_.items[leaf.first].type << kRefType | (leaf.count - 1) << kRefCount | index_[leaf.first];
}

} // namespace lightbench
