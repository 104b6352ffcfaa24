// Builds the structure that is asked for. In: primitives. Out: its tables, the primitives in its order.
#include "accel/accel.h"

#include "accel/parallel.h"
#include "accel/tables.h"
#include "accel/voxels.h"

#include <algorithm>
#include <chrono>
#include <functional>

namespace lightbench {
namespace {

// A table that an earlier structure has ordered goes back to the order of the numbers.
template <typename Primitive> void restore(std::vector<Primitive>& table, std::size_t first) {
    const auto smaller = [](const Primitive& a, const Primitive& b) { return a.number < b.number; };
    if (std::is_sorted(table.begin(), table.end(), smaller)) return;
    std::vector<Primitive> ordered(table.size());
    for (const Primitive& primitive : table) ordered[primitive.number - first] = primitive;
    table.swap(ordered);
}

std::vector<TreeItem> items_of(const RayPrimitives& primitives) {
    const auto boxes = boxes_of(primitives);
    std::vector<TreeItem> items;
    items.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool triangle = i < primitives.triangles.size(), sphere = i < primitives.triangles.size() + primitives.spheres.size();
        const auto type = triangle ? gpu_layout::kTypeTriangle : sphere ? gpu_layout::kTypeSphere : gpu_layout::kTypeShape;
        items.push_back({boxes[i], static_cast<std::uint32_t>(i), type});
    }
    return items;
}

template <typename Primitive>
void reorder(std::vector<Primitive>& table, std::size_t first, const std::vector<TreeItem>& items, std::uint32_t type) {
    std::vector<Primitive> ordered;
    ordered.reserve(table.size());
    for (const TreeItem& item : items)
        if (item.type == type) ordered.push_back(table[item.slot - first]);
    table.swap(ordered);
}

void order_as(RayPrimitives& primitives, const std::vector<TreeItem>& items) {
    const std::size_t spheres = primitives.triangles.size(), shapes = spheres + primitives.spheres.size();
    reorder(primitives.triangles, 0, items, gpu_layout::kTypeTriangle);
    reorder(primitives.spheres, spheres, items, gpu_layout::kTypeSphere);
    reorder(primitives.shapes, shapes, items, gpu_layout::kTypeShape);
}

// A leaf tests every type that the tree holds, on drivers that run both sides of an `if`: a floor of two triangles under a thousand spheres
// would be paid for in each leaf. So a type of up to kLoose primitives, beside at least kCrowd others, stays out of the tree; the large
// things that are alone of their kind also shorten rays before the walk begins.
constexpr std::uint32_t kLoose = 4, kCrowd = 64;

// Takes them out of `items`.
std::vector<TreeItem> take_loose(std::vector<TreeItem>& items, AccelTables& tables) {
    std::array<std::size_t, 3> counts{};
    for (const TreeItem& item : items) ++counts[item.type];
    tables.loose = loose_types(counts);
    std::vector<TreeItem> loose;
    std::erase_if(items, [&](const TreeItem& item) {
        if (tables.loose[item.type] > 0) loose.push_back(item);
        return tables.loose[item.type] > 0;
    });
    return loose;
}

constexpr std::uint32_t kLeaf = 4; // primitives of a leaf at most, as a reference counts them

void take_narrow(AccelTables& tables, AccelTables&& narrow) {
    tables.narrow = std::move(narrow.narrow);
    tables.narrow_origin = narrow.narrow_origin;
    tables.narrow_step = narrow.narrow_step;
    tables.narrow_inflation = narrow.narrow_inflation;
    tables.stack = std::max(tables.stack, narrow.stack);
}

void build_tree_of(AccelTables& tables, RayPrimitives& primitives, const AccelRequest& request) {
    const std::uint32_t leaf = std::clamp(request.leaf == 0 ? kLeaf : request.leaf, 1u, kLeaf);
    const bool boxes = request.accel == Accel::bvh;
    std::vector<TreeItem> items = items_of(primitives), order;
    if (boxes) order = take_loose(items, tables);
    const Tree tree = build_tree(std::move(items), leaf, request.threads);
    order.insert(order.end(), tree.items.begin(), tree.items.end());
    const auto spheres = boxes ? std::vector<glm::vec4>{} : spheres_of(primitives);
    AccelTables narrow;
    narrow.loose = tables.loose;
    const std::array<std::function<void()>, 3> rest{[&] { boxes ? add_wide(tables, tree) : add_spheres(tables, tree, spheres); },
                                                    [&] { boxes ? add_narrow(narrow, tree) : void(); },
                                                    [&] { order_as(primitives, order); }};
    run_parallel(rest.size(), request.threads, [&](std::size_t i) { rest[i](); });
    if (boxes) take_narrow(tables, std::move(narrow));
    tables.node_count = tables.nodes.size() / (boxes ? gpu_layout::kWideTexels : gpu_layout::kSphereNodeTexels);
    tables.reference_count = tree.items.size();
    tables.depth = tree.depth;
}

} // namespace

std::array<std::uint32_t, 3> loose_types(const std::array<std::size_t, 3>& counts) {
    const std::size_t all = counts[0] + counts[1] + counts[2];
    std::array<std::uint32_t, 3> loose{};
    for (std::size_t type = 0; type < counts.size(); ++type)
        if (counts[type] <= kLoose && all - counts[type] >= kCrowd) loose[type] = static_cast<std::uint32_t>(counts[type]);
    return loose;
}

AccelTables build_accel(RayPrimitives& primitives, const AccelRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t spheres = primitives.triangles.size(), shapes = spheres + primitives.spheres.size();
    restore(primitives.triangles, 0);
    restore(primitives.spheres, spheres);
    restore(primitives.shapes, shapes);
    AccelTables tables;
    tables.accel = request.accel;
    switch (request.accel) {
    case Accel::none: tables.stack = 1; break;
    case Accel::bvh:
    case Accel::sphere_bvh: build_tree_of(tables, primitives, request); break;
    case Accel::grid: build_grid(tables, primitives, request); break;
    case Accel::octree: build_octree(tables, primitives, request); break;
    }
    tables.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return tables;
}

} // namespace lightbench
