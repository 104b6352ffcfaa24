// Where a set of boxes is cut in two. In: items of a node. Out: how many of them, reordered, form the first child.
#pragma once

#include "accel/tree.h"

#include <span>

namespace lightbench {

struct Split {
    std::size_t first = 0; // items of the first child, 0: none found (all centroids equal)
    double cost = 0;       // of both children: sum of half area times items
};

// Reorders `items` so that those of the first child come first, if the split is cheaper than `limit` (pass infinity to always split).
Split split_by_area(std::span<TreeItem> items, double limit);

// Half of them each, along the axis on which the centroids lie farthest apart; by index where they coincide.
std::size_t split_in_half(std::span<TreeItem> items);

// First those of the type of items[0]; all of them if there is no other.
std::size_t split_by_type(std::span<TreeItem> items);

FloatBox box_of(std::span<const TreeItem> items);

} // namespace lightbench
