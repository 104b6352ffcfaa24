// What all tables of a binary tree share: the names of leaves and of inner nodes. In: Tree. Out: references, numbers.
#include "accel/tables.h"

namespace lightbench {

LeafReferences::LeafReferences(const Tree& tree, const std::array<std::uint32_t, 3>& before) : tree_(tree) {
    std::array<std::uint32_t, 3> next = before;
    index_.reserve(tree.items.size());
    for (const TreeItem& item : tree.items) index_.push_back(next[item.type]++);
}

std::uint32_t LeafReferences::of(const TreeNode& leaf) const {
    using namespace gpu_layout;
    return kRefLeaf | tree_.items[leaf.first].type << kRefType | (leaf.count - 1) << kRefCount | index_[leaf.first];
}

std::vector<std::uint32_t> inner_numbers(const Tree& tree) {
    std::vector<std::uint32_t> numbers(tree.nodes.size()), open{0};
    std::uint32_t next = 0;
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        if (tree.nodes[node].count > 0) continue;
        numbers[node] = next++;
        open.push_back(tree.nodes[node].first + 1);
        open.push_back(tree.nodes[node].first);
    }
    return numbers;
}

} // namespace lightbench
