// Builds the binary tree: the top by one thread, the subtrees below it as independent pieces whose size depends on the items alone.
#include "accel/tree.h"

#include "accel/parallel.h"
#include "accel/split.h"

#include <bit>
#include <limits>

namespace lightbench {
namespace {

constexpr std::size_t kPiece = 8192; // items of a subtree that one thread builds alone

std::uint32_t log2_above(std::size_t n) {
    return static_cast<std::uint32_t>(std::bit_width(n > 1 ? n - 1 : std::size_t{0}));
}

struct Task {
    std::uint32_t node = 0; // its number among the nodes at hand
    std::size_t first = 0, count = 0;
    std::uint32_t depth = 0;
};

class Builder {
  public:
    Builder(std::vector<TreeItem>& items, std::uint32_t leaf) : items_(items), leaf_(leaf), limit_(2 * log2_above(items.size()) + 5) {}

    // Builds the tree of `root`; tasks of at most `piece` items are put off into `later`. Depth is counted from the whole tree's root.
    std::vector<TreeNode> build(Task root, std::size_t piece, std::vector<Task>* later, std::uint32_t& depth) const;

  private:
    std::span<TreeItem> span_of(const Task& task) const { return std::span(items_).subspan(task.first, task.count); }
    std::size_t split(const Task& task, double area) const;

    std::vector<TreeItem>& items_;
    std::uint32_t leaf_;
    std::uint32_t limit_; // types may add two levels below it, and rounding log2 N up one
};

// 0: a leaf. Halving must still bring the items to leaves above the limit.
std::size_t Builder::split(const Task& task, double area) const {
    const auto items = span_of(task);
    const bool may_be_leaf = task.count <= leaf_;
    if (task.count == 1) return 0;
    if (task.depth + log2_above(task.count) >= limit_) {
        if (may_be_leaf) return split_by_type(items) % task.count;
        return split_in_half(items);
    }
    const double as_leaf = (static_cast<double>(task.count) - kOpenCost) * area;
    const Split found = split_by_area(items, may_be_leaf ? as_leaf : std::numeric_limits<double>::infinity());
    if (found.first > 0) return found.first;
    return may_be_leaf ? split_by_type(items) % task.count : split_in_half(items);
}

std::vector<TreeNode> Builder::build(Task root, std::size_t piece, std::vector<Task>* later, std::uint32_t& depth) const {
    std::vector<TreeNode> nodes(1);
    root.node = 0;
    std::vector<Task> open{root};
    while (!open.empty()) {
        const Task task = open.back();
        open.pop_back();
        depth = std::max(depth, task.depth);
        if (later && task.count <= piece) {
            later->push_back(task);
            continue;
        }
        const FloatBox box = box_of(span_of(task));
        const std::size_t first = split(task, half_area(box));
        if (first == 0) {
            nodes[task.node] = {box, static_cast<std::uint32_t>(task.first), static_cast<std::uint32_t>(task.count)};
            continue;
        }
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[task.node] = {box, child, 0};
        nodes.resize(nodes.size() + 2);
        open.push_back({child + 1, task.first + first, task.count - first, task.depth + 1});
        open.push_back({child, task.first, first, task.depth + 1});
    }
    return nodes;
}

// Node 0 of a piece takes the place that was kept for it; the others follow what is there.
void append(std::vector<TreeNode>& nodes, std::uint32_t place, const std::vector<TreeNode>& piece) {
    const auto offset = static_cast<std::uint32_t>(nodes.size()) - 1;
    const auto moved = [offset](TreeNode node) {
        if (node.count == 0) node.first += offset;
        return node;
    };
    nodes[place] = moved(piece[0]);
    for (std::size_t i = 1; i < piece.size(); ++i) nodes.push_back(moved(piece[i]));
}

} // namespace

Tree build_tree(std::vector<TreeItem> items, std::uint32_t leaf, unsigned threads) {
    Tree tree;
    tree.items = std::move(items);
    if (tree.items.empty()) return tree;
    const Builder builder(tree.items, leaf);
    std::vector<Task> pieces;
    tree.nodes = builder.build({0, 0, tree.items.size(), 0}, kPiece, &pieces, tree.depth);
    std::vector<std::vector<TreeNode>> built(pieces.size());
    std::vector<std::uint32_t> depths(pieces.size());
    run_parallel(pieces.size(), threads, [&](std::size_t i) { built[i] = builder.build(pieces[i], 0, nullptr, depths[i]); });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        append(tree.nodes, pieces[i].node, built[i]);
        built[i] = {};
        tree.depth = std::max(tree.depth, depths[i]);
    }
    return tree;
}

} // namespace lightbench
