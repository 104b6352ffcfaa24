// The binary tree of boxes that every hierarchy starts from. In: boxes, types. Out: nodes in one array, items in leaf order.
#pragma once

#include "accel/primitives.h"

#include <cstdint>
#include <vector>

namespace lightbench {

struct TreeItem {
    FloatBox box;
    std::uint32_t slot = 0; // index into the boxes that were given
    std::uint32_t type = 0; // kType...
};

struct TreeNode {
    FloatBox box;
    std::uint32_t first = 0; // count 0: the first of two children, which follow each other; else of the leaf's items
    std::uint32_t count = 0; // items of a leaf, all of one type; 0: not a leaf
};

struct Tree {
    std::vector<TreeNode> nodes; // the root is nodes[0]; empty if there are no items
    std::vector<TreeItem> items; // in leaf order
    std::uint32_t depth = 0;     // levels below the root
};

// Cost of the surface-area heuristic, MacDonald, Booth 1990: what opening a node costs, in tests of a primitive.
constexpr double kOpenCost = 1;

// Surface-area heuristic over binned centroids; leaves of at most `leaf` items of one type; no leaf lies deeper than 2 log2 N + 8.
// The same tree whatever the number of threads.
Tree build_tree(std::vector<TreeItem> items, std::uint32_t leaf, unsigned threads = 0);

// Part of the surface, in double: sides of 1e30 do not overflow.
double half_area(const FloatBox& box);

} // namespace lightbench
