// Walks through the structures' tables in double precision, in the order of the shaders.
#include "accel_support.h"

#include <bit>
#include <cmath>

namespace lightbench::accel_tests {
namespace {

float bits(std::uint32_t word) {
    return std::bit_cast<float>(word);
}

glm::dvec3 vector(const uvec4& words) {
    return {bits(words.x), bits(words.y), bits(words.z)};
}

// Where the ray enters the closed box, or infinity.
double enter(const glm::dvec3& lo, const glm::dvec3& hi, const TestRay& ray, double limit) {
    double in = 0, out = limit;
    for (int i = 0; i < 3; ++i) {
        if (lo[i] > hi[i]) return INFINITY;
        if (ray.d[i] == 0 && (ray.o[i] < lo[i] || ray.o[i] > hi[i])) return INFINITY;
        if (ray.d[i] == 0) continue;
        const double a = (lo[i] - ray.o[i]) / ray.d[i], b = (hi[i] - ray.o[i]) / ray.d[i];
        in = std::max(in, std::min(a, b)), out = std::min(out, std::max(a, b));
    }
    return in <= out ? in : INFINITY;
}

// Depth first with a stack; children(node) calls visit(entry, reference) for each child.
template <typename Children>
Found walk_tree(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray, const Children& children) {
    Found found;
    std::vector<std::uint32_t> stack{0};
    std::size_t most = 0;
    while (!stack.empty()) {
        const std::uint32_t node = stack.back();
        stack.pop_back();
        if (node & kRefLeaf) {
            test_leaf(p, node, ray, found);
            continue;
        }
        children(node, found.t, [&](double entry, std::uint32_t reference) {
            if (reference != kNothing && entry < INFINITY) stack.push_back(reference);
        });
        most = std::max(most, stack.size());
    }
    EXPECT_LE(most, tables.stack);
    return found;
}

struct Voxels {
    glm::dvec3 origin, step;
    std::array<std::uint32_t, 3> cells;
    double plane(int axis, double k) const { return origin[axis] + step[axis] * k; }
    glm::dvec3 end() const { return {plane(0, cells[0]), plane(1, cells[1]), plane(2, cells[2])}; }
    std::uint32_t cell(int axis, double x) const {
        const double k = std::floor((x - origin[axis]) / step[axis]);
        return k > 0 ? std::min(std::uint32_t(k), cells[std::size_t(axis)] - 1) : 0;
    }
};

std::uint32_t word(const AccelTables& tables, std::size_t first, std::size_t i) {
    return tables.nodes.at(first + i / 4)[int(i % 4)];
}

void test_list(const AccelTables& tables, const RayPrimitives& p, std::size_t lists, std::uint32_t first, std::uint32_t count,
               const TestRay& ray, Found& found) {
    for (std::uint32_t i = 0; i < count; ++i) test_reference(p, word(tables, lists, first + i), ray, found);
}

// The nearest of the three planes ahead of a voxel: its axis and distance.
std::pair<int, double> leave(const Voxels& voxels, const TestRay& ray, const glm::dvec3& lo, const glm::dvec3& hi) {
    int axis = 0;
    double nearest = INFINITY;
    for (int i = 0; i < 3; ++i) {
        if (ray.d[i] == 0) continue;
        const double t = (voxels.plane(i, ray.d[i] > 0 ? hi[i] : lo[i]) - ray.o[i]) / ray.d[i];
        if (t < nearest) nearest = t, axis = i;
    }
    return {axis, nearest};
}

} // namespace

Found walk_wide(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray) {
    return walk_tree(tables, p, ray, [&](std::uint32_t node, double limit, const auto& visit) {
        const uvec4* texels = &tables.nodes.at(std::size_t{kWideTexels} * node);
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 lo(bits(texels[0][i]), bits(texels[2][i]), bits(texels[4][i]));
            const glm::dvec3 hi(bits(texels[1][i]), bits(texels[3][i]), bits(texels[5][i]));
            visit(enter(lo, hi, ray, limit), texels[6][i]);
        }
    });
}

Found walk_narrow(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray) {
    const glm::dvec3 origin(tables.narrow_origin), step(tables.narrow_step);
    return walk_tree(tables, p, ray, [&](std::uint32_t node, double limit, const auto& visit) {
        for (std::size_t i = 0; i < 2; ++i) {
            const uvec4& child = tables.narrow.at(kNarrowTexels * std::size_t{node} + i);
            const glm::dvec3 lo(child.x & 0xffffu, child.y & 0xffffu, child.z & 0xffffu), hi(child.x >> 16, child.y >> 16, child.z >> 16);
            visit(enter(origin + step * lo, origin + step * hi, ray, limit), child.w);
        }
    });
}

Found walk_spheres(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray) {
    return walk_tree(tables, p, ray, [&](std::uint32_t node, double limit, const auto& visit) {
        const uvec4* texels = &tables.nodes.at(std::size_t{kSphereNodeTexels} * node);
        for (int i = 0; i < 2; ++i) {
            const glm::dvec3 to = vector(texels[i]) - ray.o;
            const double radius = bits(texels[i].w), middle = glm::dot(to, ray.d);
            const double left = radius * radius - glm::dot(to - middle * ray.d, to - middle * ray.d);
            const bool meets = radius >= 0 && left >= 0 && middle + std::sqrt(left) >= 0 && middle - std::sqrt(left) <= limit;
            visit(meets ? 0 : INFINITY, texels[2][i]);
        }
    });
}

Found walk_grid(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray) {
    const Voxels voxels{vector(tables.nodes[0]), vector(tables.nodes[1]), {tables.nodes[0].w, tables.nodes[1].w, tables.nodes[2].x}};
    Found found;
    const double start = enter(voxels.origin, voxels.end(), ray, INFINITY);
    if (start == INFINITY) return found;
    glm::dvec3 at; // whole numbers
    for (int i = 0; i < 3; ++i) at[i] = voxels.cell(i, ray.o[i] + start * ray.d[i]);
    std::size_t steps = 0;
    for (;;) {
        const std::size_t cell = std::size_t(at.x + voxels.cells[0] * (at.y + double(voxels.cells[1]) * at.z));
        test_list(tables, p, tables.nodes[2].y, word(tables, kGridHeaderTexels, 2 * cell), word(tables, kGridHeaderTexels, 2 * cell + 1),
                  ray, found);
        const auto [axis, t] = leave(voxels, ray, at, at + 1.0);
        if (found.t <= t) break;
        at[axis] += ray.d[axis] > 0 ? 1 : -1;
        if (at[axis] < 0 || at[axis] >= voxels.cells[std::size_t(axis)]) break;
        ++steps;
    }
    EXPECT_LE(steps, voxels.cells[0] + voxels.cells[1] + voxels.cells[2] + 3); // TS-8
    return found;
}

Found walk_octree(const AccelTables& tables, const RayPrimitives& p, const TestRay& ray) {
    const Voxels voxels{vector(tables.nodes[0]), vector(tables.nodes[1]), {kOctreeSide, kOctreeSide, kOctreeSide}};
    Found found;
    const double start = enter(voxels.origin, voxels.end(), ray, INFINITY);
    if (start == INFINITY) return found;
    std::array<std::uint32_t, 3> at{};
    for (int i = 0; i < 3; ++i) at[std::size_t(i)] = voxels.cell(i, ray.o[i] + start * ray.d[i]);
    for (;;) {
        std::uint32_t name = tables.nodes[0].w, side = kOctreeSide;
        while (!(name & kRefLeaf)) {
            side /= 2;
            std::uint32_t child = 0;
            for (std::size_t i = 0; i < 3; ++i) child |= std::uint32_t((at[i] & side) != 0) << i;
            name = word(tables, kOctreeHeaderTexels, 8 * std::size_t{name} + child);
        }
        const std::size_t leaf = name & ~kRefLeaf, leaves = tables.nodes[1].w;
        if (name != kNothing)
            test_list(tables, p, tables.nodes[2].x, word(tables, leaves, 2 * leaf), word(tables, leaves, 2 * leaf + 1), ray, found);
        glm::dvec3 lo, hi;
        for (int i = 0; i < 3; ++i) lo[i] = at[std::size_t(i)] & ~(side - 1), hi[i] = lo[i] + side;
        const auto [axis, t] = leave(voxels, ray, lo, hi);
        if (found.t <= t) break;
        for (int i = 0; i < 3; ++i) {
            const double x = voxels.cell(i, ray.o[i] + t * ray.d[i]), now = at[std::size_t(i)];
            const double to =
                i == axis ? (ray.d[i] > 0 ? hi[i] : lo[i] - 1) : glm::clamp(x, ray.d[i] > 0 ? now : lo[i], ray.d[i] > 0 ? hi[i] - 1 : now);
            if (to < 0 || to >= kOctreeSide) return found;
            at[std::size_t(i)] = std::uint32_t(to);
        }
    }
    return found;
}

} // namespace lightbench::accel_tests
