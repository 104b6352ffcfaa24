// Nodes hold what is below them: boxes of children within their parent's, primitives within all boxes and spheres above them.
#include "accel_support.h"

#include "accel/tree.h"

#include <bit>
#include <functional>

namespace lightbench::accel_tests {
namespace {

float bits(std::uint32_t word) {
    return std::bit_cast<float>(word);
}

bool within(const FloatBox& inner, const FloatBox& outer) {
    return glm::all(glm::greaterThanEqual(inner.min, outer.min)) && glm::all(glm::lessThanEqual(inner.max, outer.max));
}

// Calls visit(reference) for every primitive of a leaf.
void each(std::uint32_t leaf, const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
    EXPECT_NE(leaf, kNothing);
    for (std::uint32_t i = 0; i <= (leaf >> kRefCount & 3u); ++i) visit(leaf >> kRefType & 3u, (leaf & kRefIndex) + i);
}

std::uint32_t number_of(const RayPrimitives& p, std::uint32_t type, std::uint32_t index) {
    return type == kTypeTriangle ? p.triangles.at(index).number
           : type == kTypeSphere ? p.spheres.at(index).number
                                 : p.shapes.at(index).number;
}

struct Checked {
    const AccelTables& tables;
    const RayPrimitives& primitives;
    std::vector<FloatBox> boxes = boxes_of(primitives);
    std::vector<glm::vec4> spheres = spheres_of(primitives);
    std::vector<int> seen = std::vector<int>(primitives.size());

    void leaf(std::uint32_t reference, const FloatBox& box) {
        each(reference, [&](std::uint32_t type, std::uint32_t index) {
            const std::uint32_t n = number_of(primitives, type, index);
            ++seen.at(n);
            EXPECT_TRUE(within(boxes[n], box));
        });
    }

    void wide(std::uint32_t node, const FloatBox& box) {
        const uvec4* t = &tables.nodes.at(std::size_t{kWideTexels} * node);
        for (int i = 0; i < 4; ++i) {
            const FloatBox child{{bits(t[0][i]), bits(t[2][i]), bits(t[4][i])}, {bits(t[1][i]), bits(t[3][i]), bits(t[5][i])}};
            if (t[6][i] == kNothing) {
                EXPECT_TRUE(child.empty());
                continue;
            }
            EXPECT_TRUE(within(child, box));
            if (t[6][i] & kRefLeaf)
                leaf(t[6][i], child);
            else
                wide(t[6][i], child);
        }
    }

    void narrow(std::uint32_t node, const FloatBox& box) {
        for (std::size_t i = 0; i < 2; ++i) {
            const uvec4& t = tables.narrow.at(kNarrowTexels * std::size_t{node} + i);
            if (t.w == kNothing) continue;
            FloatBox child;
            for (int a = 0; a < 3; ++a) {
                child.min[a] = float(double{tables.narrow_origin[a]} + double{tables.narrow_step[a]} * (t[a] & 0xffffu));
                child.max[a] = float(double{tables.narrow_origin[a]} + double{tables.narrow_step[a]} * (t[a] >> 16));
            }
            EXPECT_TRUE(within(child, box));
            if (t.w & kRefLeaf)
                leaf(t.w, child);
            else
                narrow(t.w, child);
        }
    }

    // A primitive's sphere lies within each sphere above it. Returns the numbers below.
    std::vector<std::uint32_t> spheres_below(std::uint32_t reference) {
        std::vector<std::uint32_t> numbers;
        if (reference == kNothing) return numbers;
        if (reference & kRefLeaf) {
            each(reference, [&](std::uint32_t type, std::uint32_t index) { numbers.push_back(number_of(primitives, type, index)); });
            return numbers;
        }
        const uvec4* t = &tables.nodes.at(std::size_t{kSphereNodeTexels} * reference);
        for (int i = 0; i < 2; ++i) {
            const glm::dvec3 center(bits(t[i].x), bits(t[i].y), bits(t[i].z));
            for (std::uint32_t n : spheres_below(t[2][i])) {
                EXPECT_LE(glm::length(glm::dvec3(spheres[n]) - center) + double{spheres[n].w}, double{bits(t[i].w)});
                numbers.push_back(n);
            }
        }
        return numbers;
    }
};

const FloatBox kAll{glm::vec3(-3e38f), glm::vec3(3e38f)};

TEST(AccelTree, NodesHoldWhatIsBelow) {
    for (int kind = 0; kind < kKinds; ++kind)
        for (std::uint32_t count : {1u, 4u, 5u, 2000u}) {
            RayPrimitives p = generate(Kind(kind), count, 31);
            const AccelTables tables = build_accel(p, {});
            Checked wide{tables, p}, narrow{tables, p};
            wide.wide(0, kAll);
            narrow.narrow(0, kAll);
            const AccelTables spheres = build_accel(p, {.accel = Accel::sphere_bvh});
            Checked of_spheres{spheres, p};
            EXPECT_EQ(of_spheres.spheres_below(0).size(), count);
            for (const auto* seen : {&wide.seen, &narrow.seen})
                for (int times : *seen) ASSERT_EQ(times, 1);
        }
}

TEST(AccelTree, LeavesHaveOneType) {
    RayPrimitives p = generate(Kind::mixed, 3000, 4);
    std::vector<TreeItem> items;
    for (const FloatBox& box : boxes_of(p)) items.push_back({box, std::uint32_t(items.size()), std::uint32_t(items.size() % 3)});
    const Tree tree = build_tree(items, 4);
    std::size_t in_leaves = 0;
    for (const TreeNode& node : tree.nodes) {
        EXPECT_LE(node.count, 4u);
        in_leaves += node.count;
        for (std::uint32_t i = 0; i < node.count; ++i) EXPECT_EQ(tree.items[node.first + i].type, tree.items[node.first].type);
    }
    EXPECT_EQ(in_leaves, items.size());
    EXPECT_EQ(tree.nodes.size() % 2, 1u);
}

// Two rows of boxes far apart: the first cut goes between them, whatever lies in the middle by number.
TEST(AccelTree, CutsWhereItIsCheapest) {
    std::vector<TreeItem> items;
    for (std::uint32_t i = 0; i < 100; ++i) {
        const float x = i < 90 ? 0.001f * float(i) : 10 + 0.001f * float(i);
        items.push_back({{{x, 0, 0}, {x + 0.0005f, 1, 1}}, i, 0});
    }
    const Tree tree = build_tree(items, 4);
    const FloatBox left = tree.nodes[tree.nodes[0].first].box, right = tree.nodes[tree.nodes[0].first + 1].box;
    EXPECT_LT(std::min(left.max.x, right.max.x), 1);
    EXPECT_GT(std::max(left.min.x, right.min.x), 9);
}

} // namespace
} // namespace lightbench::accel_tests
