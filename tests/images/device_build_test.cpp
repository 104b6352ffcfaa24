// The tree that is built on the device: each node holds what is below it, in both tables; sets that break builders.
#include "images/gpu_fixture.h"

#include "accel/accel.h"
#include "gpu/buffer.h"
#include "render/device_build.h"
#include "unit/accel_support.h"

#include <algorithm>
#include <fmt/format.h>

namespace lightbench {
namespace {

using namespace gpu_layout;
using accel_tests::Kind;

class DeviceBuild : public gpu::GpuTest {};

struct Built {
    RayPrimitives primitives; // in the order of the leaves
    AccelTables tables;       // filled
};

template <class T> std::vector<T> values_of(gpu::Device& device, gpu::Buffer& buffer) {
    std::vector<T> values(buffer ? buffer.size() / sizeof(T) : 0);
    if (buffer) gpu::download(device, buffer, std::as_writable_bytes(std::span(values)));
    return values;
}

Built build(gpu::Device& device, DeviceBuilder& builder, const RayPrimitives& primitives, std::uint32_t leaf) {
    DeviceTree tree = builder.build(primitives, leaf);
    Built built{primitives, std::move(tree.accel)};
    built.primitives.triangles = values_of<RayTriangle>(device, tree.triangles);
    built.primitives.spheres = values_of<RaySphere>(device, tree.spheres);
    built.primitives.shapes = values_of<RayShape>(device, tree.shapes);
    built.tables.nodes = values_of<uvec4>(device, tree.nodes);
    built.tables.narrow = values_of<uvec4>(device, tree.narrow);
    return built;
}

bool within(const FloatBox& inner, const FloatBox& outer) {
    return glm::all(glm::greaterThanEqual(inner.min, outer.min)) && glm::all(glm::lessThanEqual(inner.max, outer.max));
}

const FloatBox kAll{glm::vec3(-3e38f), glm::vec3(3e38f)};

// Visits a tree from its root; counts how often each primitive is met.
class Visit {
  public:
    Visit(const Built& built, const std::vector<FloatBox>& boxes, std::uint32_t leaf)
        : b_(built), boxes_(boxes), leaf_(leaf), seen_(boxes.size()) {
        for (std::uint32_t i = 0; i < b_.tables.loose[0]; ++i) ++seen_[b_.primitives.triangles[i].number];
        for (std::uint32_t i = 0; i < b_.tables.loose[1]; ++i) ++seen_[b_.primitives.spheres[i].number];
        for (std::uint32_t i = 0; i < b_.tables.loose[2]; ++i) ++seen_[b_.primitives.shapes[i].number];
    }

    void wide(std::uint32_t node, const FloatBox& box, std::uint32_t stack) {
        const uvec4* t = &b_.tables.nodes.at(std::size_t{kWideTexels} * node);
        std::uint32_t children = 0;
        for (int i = 0; i < 4; ++i) children += t[6][i] != kNothing;
        EXPECT_GE(children, 2u);
        stack += children - 1;
        EXPECT_LE(stack + 3, b_.tables.stack); // as accel/bvh_wide.cpp counts
        for (int i = 0; i < 4; ++i) {
            const FloatBox child{glm::uintBitsToFloat(glm::uvec3(t[0][i], t[2][i], t[4][i])),
                                 glm::uintBitsToFloat(glm::uvec3(t[1][i], t[3][i], t[5][i]))};
            if (t[6][i] == kNothing) {
                EXPECT_TRUE(child.empty());
                continue;
            }
            EXPECT_TRUE(within(child, box));
            t[6][i] & kRefLeaf ? leaf(t[6][i], child) : wide(t[6][i], child, stack);
        }
    }

    void narrow(std::uint32_t node, const FloatBox& box, std::uint32_t depth) {
        deepest_ = std::max(deepest_, depth + 1);
        for (std::size_t i = 0; i < 2; ++i) {
            const uvec4& t = b_.tables.narrow.at(2 + kNarrowTexels * std::size_t{node} + i);
            FloatBox child;
            for (int a = 0; a < 3; ++a) {
                child.min[a] = float(double{b_.tables.narrow_origin[a]} + double{b_.tables.narrow_step[a]} * (t[a] & 0xffffu));
                child.max[a] = float(double{b_.tables.narrow_origin[a]} + double{b_.tables.narrow_step[a]} * (t[a] >> 16));
            }
            EXPECT_TRUE(within(child, box));
            t.w& kRefLeaf ? leaf(t.w, child) : narrow(t.w, child, depth + 1);
        }
    }

    void expect_all_met_once() const {
        for (std::size_t i = 0; i < seen_.size(); ++i) ASSERT_EQ(seen_[i], 1) << i;
    }
    std::uint32_t deepest() const { return deepest_; }

  private:
    void leaf(std::uint32_t reference, const FloatBox& box) {
        ASSERT_NE(reference, kNothing);
        const std::uint32_t count = (reference >> kRefCount & 3u) + 1, type = reference >> kRefType & 3u;
        EXPECT_LE(count, leaf_);
        for (std::uint32_t i = reference & kRefIndex, end = i + count; i < end; ++i) {
            const RayPrimitives& p = b_.primitives;
            const std::uint32_t n = type == kTypeTriangle ? p.triangles.at(i).number
                                    : type == kTypeSphere ? p.spheres.at(i).number
                                                          : p.shapes.at(i).number;
            ++seen_.at(n);
            EXPECT_TRUE(within(boxes_[n], box));
        }
    }

    const Built& b_;
    const std::vector<FloatBox>& boxes_;
    std::uint32_t leaf_, deepest_ = 0;
    std::vector<int> seen_;
};

void expect_sound(const Built& built, const RayPrimitives& primitives, std::uint32_t leaf) {
    const std::vector<FloatBox> boxes = boxes_of(primitives);
    Visit wide(built, boxes, leaf), narrow(built, boxes, leaf);
    wide.wide(0, kAll, 0);
    wide.expect_all_met_once();
    narrow.narrow(0, kAll, 0);
    narrow.expect_all_met_once();
    EXPECT_EQ(narrow.deepest(), built.tables.depth);
}

TEST_F(DeviceBuild, NodesHoldWhatIsBelow) {
    DeviceBuilder builder(device());
    for (int kind = 0; kind < accel_tests::kKinds; ++kind)
        for (const std::uint32_t count : {2u, 3u, 4u, 5u, 9u, 2000u})
            for (const std::uint32_t leaf : {1u, 4u}) {
                const RayPrimitives p = accel_tests::generate(Kind(kind), count, 31);
                SCOPED_TRACE(fmt::format("kind {}, {} primitives, leaf {}", kind, count, leaf));
                expect_sound(build(device(), builder, p, leaf), p, leaf);
                if (HasFailure()) return;
            }
}

TEST_F(DeviceBuild, AllInOnePlace) {
    DeviceBuilder builder(device());
    RayPrimitives p;
    for (int i = 0; i < 3000; ++i) accel_tests::add_sphere(p, {0.25f, 0.5f, -1}, 0.25f);
    accel_tests::number(p);
    const Built built = build(device(), builder, p, 4);
    expect_sound(built, p, 4);
    EXPECT_LE(built.tables.depth, 12u); // by their places, in halves
}

TEST_F(DeviceBuild, FewOfATypeStayOutside) {
    DeviceBuilder builder(device());
    RayPrimitives p = accel_tests::generate(Kind::spheres, 500, 2);
    accel_tests::add_triangle(p, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    accel_tests::number(p);
    const Built built = build(device(), builder, p, 4);
    EXPECT_EQ(built.tables.loose[kTypeTriangle], 1u);
    expect_sound(built, p, 4);
}

// A smaller build after a larger one, in the same buffers; the same bytes each time.
TEST_F(DeviceBuild, BuildsAgainAsBefore) {
    DeviceBuilder builder(device()), fresh(device());
    const RayPrimitives large = accel_tests::generate(Kind::mixed, 20'000, 1), small = accel_tests::generate(Kind::mixed, 3000, 2);
    builder.warm_up(large);
    const Built a = build(device(), builder, large, 4);
    const Built b = build(device(), builder, small, 4), c = build(device(), fresh, small, 4);
    expect_sound(a, large, 4);
    expect_sound(b, small, 4);
    EXPECT_TRUE(b.tables.narrow == c.tables.narrow && b.tables.nodes == c.tables.nodes);
}

TEST_F(DeviceBuild, AMillion) {
    DeviceBuilder builder(device());
    const RayPrimitives p = accel_tests::generate(Kind::triangles, 1'000'000, 9);
    expect_sound(build(device(), builder, p, 4), p, 4);
}

} // namespace
} // namespace lightbench
