// The tree with four children a node and exact boxes (shaders/shared/rays.h: kWideTexels). In: Tree. Out: AccelTables::nodes.
#include "accel/tables.h"

#include <algorithm>
#include <bit>

namespace lightbench {
namespace {

using gpu_layout::uvec4;

struct Wide {
    std::array<const TreeNode*, 4> children{};
    std::size_t count = 0;
};

// Opens the inner child of the largest area until four children are there: it is the one that rays meet most.
Wide wide_of(const Tree& tree, const TreeNode& node) {
    if (node.count > 0) return {{&node}, 1};
    Wide wide{{&tree.nodes[node.first], &tree.nodes[node.first + 1]}, 2};
    while (wide.count < 4) {
        std::size_t open = 4;
        for (std::size_t i = 0; i < wide.count; ++i)
            if (wide.children[i]->count == 0 && (open == 4 || half_area(wide.children[i]->box) > half_area(wide.children[open]->box)))
                open = i;
        if (open == 4) break;
        const std::uint32_t first = wide.children[open]->first;
        wide.children[open] = &tree.nodes[first];
        wide.children[wide.count++] = &tree.nodes[first + 1];
    }
    return wide;
}

struct Open {
    const TreeNode* node = nullptr;
    std::uint32_t stack = 0; // entries that lie on a walk's stack when it comes here, at most
    std::size_t parent = 0;  // texel and word that wait for its number
    int word = 0;
};

void write_child(AccelTables& tables, std::size_t at, int i, const FloatBox& box, std::uint32_t reference) {
    for (int axis = 0; axis < 3; ++axis) {
        tables.nodes[at + 2 * static_cast<std::size_t>(axis)][i] = std::bit_cast<std::uint32_t>(box.min[axis]);
        tables.nodes[at + 2 * static_cast<std::size_t>(axis) + 1][i] = std::bit_cast<std::uint32_t>(box.max[axis]);
    }
    tables.nodes[at + 6][i] = reference;
}

} // namespace

// A walk that goes into one child keeps the others: the stack grows by their number a level. Three more: one that says where the stack ends,
// one for a walk that writes first and then decides whether to keep it, one for a walk that keeps all four and then takes the last.
void add_wide(AccelTables& tables, const Tree& tree) {
    const LeafReferences references(tree, tables.loose);
    std::vector<Open> open;
    if (!tree.nodes.empty()) open.push_back({&tree.nodes[0], 0, 0, -1});
    if (tree.nodes.empty()) {
        tables.nodes.resize(gpu_layout::kWideTexels);
        for (int i = 0; i < 4; ++i) write_child(tables, 0, i, FloatBox{}, gpu_layout::kNothing);
    }
    while (!open.empty()) {
        const Open here = open.back();
        open.pop_back();
        const std::size_t at = tables.nodes.size();
        if (here.word >= 0) tables.nodes[here.parent][here.word] = static_cast<std::uint32_t>(at / gpu_layout::kWideTexels);
        tables.nodes.resize(at + gpu_layout::kWideTexels);
        const Wide wide = wide_of(tree, *here.node);
        const auto stack = here.stack + static_cast<std::uint32_t>(wide.count) - 1;
        tables.stack = std::max(tables.stack, stack + 3);
        for (int i = 0; i < 4; ++i) write_child(tables, at, i, FloatBox{}, gpu_layout::kNothing);
        for (std::size_t i = wide.count; i-- > 0;) {
            const TreeNode& child = *wide.children[i];
            write_child(tables, at, static_cast<int>(i), child.box, child.count > 0 ? references.of(child) : 0);
            if (child.count == 0) open.push_back({&child, stack, at + 6, static_cast<int>(i)});
        }
    }
}

} // namespace lightbench
