// Surface-area splits of tree nodes. In: items of a node. Out: items reordered, and where the second child begins.
// Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies": bins of centroids for many items, every split for few.
#include "accel/split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lightbench {
namespace {

constexpr std::size_t kSweep = 8; // items up to which every split is tried
constexpr std::size_t kBins = 32, kFewBins = 16, kManyItems = 4096;

glm::vec3 centroid(const FloatBox& box) {
    return 0.5f * box.min + 0.5f * box.max; // the sum of two large coordinates would overflow
}

struct Bin {
    FloatBox box;
    std::size_t count = 0;
};

// A box as (min, -max): one loop of eight minima, which compilers make two instructions of. Filling bins is half of the build.
struct PackedBox {
    std::array<float, 8> low;
    FloatBox box() const { return {{low[0], low[1], low[2]}, {-low[4], -low[5], -low[6]}}; }
    void add(PackedBox b) {
        for (std::size_t i = 0; i < low.size(); ++i) low[i] = b.low[i] < low[i] ? b.low[i] : low[i];
    }
};

PackedBox packed(const FloatBox& b) {
    return {{b.min.x, b.min.y, b.min.z, 0, -b.max.x, -b.max.y, -b.max.z, 0}};
}

struct PackedBin {
    PackedBox box;
    std::size_t count;
};

struct Best {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    std::size_t at = 0; // bin, or item, that the second child begins with
};

struct BinScale {
    float low = 0, per_unit = 0;
    std::size_t bins = 0;
    std::size_t operator()(float x) const {
        const float at = (x - low) * per_unit;
        return at >= 1 ? std::min(static_cast<std::size_t>(std::min(at, 64.0f)), bins - 1) : 0; // also of NaN
    }
};

std::array<BinScale, 3> scales_of(const FloatBox& centroids, std::size_t bins) {
    std::array<BinScale, 3> scales;
    for (int axis = 0; axis < 3; ++axis) {
        const float extent = centroids.max[axis] - centroids.min[axis], per_unit = static_cast<float>(bins) / extent;
        const bool usable = extent > 0 && per_unit <= std::numeric_limits<float>::max() && per_unit > 0;
        scales[static_cast<std::size_t>(axis)] = {centroids.min[axis], usable ? per_unit : 0, bins};
    }
    return scales;
}

// Sweeps once from the right, keeping the areas, and once from the left.
template <typename At> void sweep(std::size_t count, const At& at, int axis, Best& best) {
    std::array<double, kBins> right{};
    FloatBox box;
    std::size_t items = 0;
    for (std::size_t i = count - 1; i > 0; --i) {
        const Bin bin = at(i);
        if (bin.count == 0) {
            right[i] = i + 1 < count ? right[i + 1] : 0;
            continue;
        }
        box.add(bin.box), items += bin.count;
        right[i] = half_area(box) * static_cast<double>(items);
    }
    const std::size_t all = items + at(0).count;
    box = {}, items = 0;
    for (std::size_t i = 1; i < count; ++i) {
        const Bin bin = at(i - 1);
        if (bin.count == 0) continue; // the same split as the one before
        box.add(bin.box), items += bin.count;
        const double cost = half_area(box) * static_cast<double>(items) + right[i];
        if (items > 0 && items < all && cost < best.cost) best = {cost, axis, i};
    }
}

void sort_along(std::span<TreeItem> items, int axis) {
    std::sort(items.begin(), items.end(), [axis](const TreeItem& a, const TreeItem& b) {
        const float x = centroid(a.box)[axis], y = centroid(b.box)[axis];
        return x != y ? x < y : a.slot < b.slot;
    });
}

Split split_few(std::span<TreeItem> items, double limit) {
    Best best;
    for (int axis = 0; axis < 3; ++axis) {
        sort_along(items, axis);
        sweep(
            items.size(),
            [&](std::size_t i) {
                return Bin{items[i].box, 1};
            },
            axis, best);
    }
    if (best.axis < 0 || !(best.cost < limit)) return {};
    if (best.axis != 2) sort_along(items, best.axis);
    return {best.at, best.cost};
}

Split split_many(std::span<TreeItem> items, double limit) {
    FloatBox centroids;
    for (const TreeItem& item : items) centroids.add(centroid(item.box));
    const std::size_t bins = items.size() >= kManyItems ? kBins : kFewBins;
    const auto scales = scales_of(centroids, bins);
    std::array<std::array<PackedBin, kBins>, 3> all; // not touched beyond `bins`: most nodes are small
    for (auto& axis : all) std::fill_n(axis.begin(), bins, PackedBin{packed(FloatBox{}), 0});
    for (const TreeItem& item : items) {
        const glm::vec3 c = centroid(item.box);
        const PackedBox box = packed(item.box);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            PackedBin& bin = all[axis][scales[axis](c[static_cast<int>(axis)])];
            bin.box.add(box), ++bin.count;
        }
    }
    Best best;
    for (std::size_t axis = 0; axis < 3; ++axis)
        sweep(
            bins,
            [&](std::size_t i) {
                return Bin{all[axis][i].box.box(), all[axis][i].count};
            },
            static_cast<int>(axis), best);
    if (best.axis < 0 || !(best.cost < limit)) return {};
    const BinScale scale = scales[static_cast<std::size_t>(best.axis)];
    const auto second =
        std::partition(items.begin(), items.end(), [&](const TreeItem& item) { return scale(centroid(item.box)[best.axis]) < best.at; });
    return {static_cast<std::size_t>(second - items.begin()), best.cost};
}

} // namespace

double half_area(const FloatBox& box) {
    if (box.empty()) return 0;
    const glm::dvec3 d = glm::dvec3(box.max) - glm::dvec3(box.min);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

FloatBox box_of(std::span<const TreeItem> items) {
    FloatBox box;
    for (const TreeItem& item : items) box.add(item.box);
    return box;
}

Split split_by_area(std::span<TreeItem> items, double limit) {
    return items.size() <= kSweep ? split_few(items, limit) : split_many(items, limit);
}

std::size_t split_in_half(std::span<TreeItem> items) {
    FloatBox centroids;
    for (const TreeItem& item : items) centroids.add(centroid(item.box));
    const glm::vec3 extent = centroids.max - centroids.min;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t half = items.size() / 2;
    if (!(extent[axis] > 0)) return half;
    const auto middle = items.begin() + static_cast<std::ptrdiff_t>(half);
    std::nth_element(items.begin(), middle, items.end(), [axis](const TreeItem& a, const TreeItem& b) {
        const float x = centroid(a.box)[axis], y = centroid(b.box)[axis];
        return x != y ? x < y : a.slot < b.slot;
    });
    return half;
}

std::size_t split_by_type(std::span<TreeItem> items) {
    const auto second =
        std::stable_partition(items.begin(), items.end(), [type = items[0].type](const TreeItem& item) { return item.type == type; });
    return static_cast<std::size_t>(second - items.begin());
}

} // namespace lightbench
