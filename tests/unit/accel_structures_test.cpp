// Every structure finds what a test of every primitive finds (TS-1), on generated sets that are hard for some of them; and sets that break
// builders: nothing, one, all in one place, chains of growing boxes (TS-2, TS-3, TS-9, TS-11).
#include "accel_support.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lightbench::accel_tests {
namespace {

constexpr std::array kStructures{Accel::bvh, Accel::sphere_bvh, Accel::grid, Accel::octree};

struct Built {
    RayPrimitives primitives;
    AccelTables tables;
};

Built built(RayPrimitives primitives, AccelRequest request) {
    Built out{std::move(primitives), {}};
    out.tables = build_accel(out.primitives, request);
    return out;
}

void expect_same(const Built& b, const Found& expected, const Found& found, const char* walk) {
    ASSERT_EQ(expected.number, found.number) << walk << ": " << expected.t << " against " << found.t << ", " << b.primitives.size();
    if (expected.number != kNothing) {
        ASSERT_EQ(expected.t, found.t) << walk;
    }
}

void expect_same_hits(const RayPrimitives& primitives, std::uint32_t seed, int rays, const AccelRequest& base = {}) {
    std::vector<Built> all;
    for (Accel accel : kStructures) {
        AccelRequest request = base;
        request.accel = accel;
        all.push_back(built(primitives, request));
    }
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < rays && !testing::Test::HasFatalFailure(); ++i) {
        const TestRay ray = random_ray(random);
        const Found expected = test_all(primitives, ray);
        hits += expected.number != kNothing;
        expect_same(all[0], expected, walk_wide(all[0].tables, all[0].primitives, ray), "wide");
        expect_same(all[0], expected, walk_narrow(all[0].tables, all[0].primitives, ray), "narrow");
        expect_same(all[1], expected, walk_spheres(all[1].tables, all[1].primitives, ray), "spheres");
        expect_same(all[2], expected, walk_grid(all[2].tables, all[2].primitives, ray), "grid");
        expect_same(all[3], expected, walk_octree(all[3].tables, all[3].primitives, ray), "octree");
    }
    if (primitives.size() > 50) {
        EXPECT_GT(hits, rays / 200);
    }
}

struct Set {
    int kind;
    std::uint32_t count;
};

class AccelSets : public testing::TestWithParam<Set> {};

TEST_P(AccelSets, AllStructuresFindTheSame) {
    const auto [kind, count] = GetParam();
    expect_same_hits(generate(Kind(kind), count, 17 + count), count, count > 400 ? 3000 : 5000);
}

std::vector<Set> sets() {
    std::vector<Set> all;
    for (int kind = 0; kind < kKinds; ++kind)
        for (std::uint32_t count : {7u, 90u, 500u}) all.push_back({kind, count});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Kinds, AccelSets, testing::ValuesIn(sets()));

TEST(Accel, SettingsChangeNoHit) {
    const auto primitives = generate(Kind::mixed, 200, 3);
    AccelRequest request{.leaf = 1, .cells = {7, 1, 30}, .depth = 3};
    expect_same_hits(primitives, 1, 1000, request);
    request = {.leaf = 2, .density = 40};
    expect_same_hits(primitives, 2, 1000, request);
}

TEST(Accel, NoPrimitivesAndOne) {
    expect_same_hits(RayPrimitives{}, 1, 200);
    for (int kind = 0; kind < kKinds; ++kind) expect_same_hits(generate(Kind(kind), 1, 5), 2, 500);
    const auto none = built({}, {});
    ASSERT_EQ(none.tables.nodes.size(), kWideTexels);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(none.tables.nodes[6][i], kNothing);
    ASSERT_EQ(none.tables.narrow.size(), kNarrowTexels);
    EXPECT_EQ(none.tables.narrow[0].w, kNothing);
    EXPECT_EQ(none.tables.narrow[1].w, kNothing);
}

bool same_bytes(const auto& a, const auto& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

bool same_built(const Built& a, const Built& b) {
    const bool tables = same_bytes(a.tables.nodes, b.tables.nodes) && same_bytes(a.tables.narrow, b.tables.narrow);
    return tables && same_bytes(a.primitives.triangles, b.primitives.triangles) && same_bytes(a.primitives.spheres, b.primitives.spheres) &&
           same_bytes(a.primitives.shapes, b.primitives.shapes) && a.tables.stack == b.tables.stack;
}

TEST(Accel, SameBytesWhateverTheThreads) {
    for (Kind kind : {Kind::spheres, Kind::mixed, Kind::planes, Kind::slivers})
        for (Accel accel : kStructures) {
            const auto primitives = generate(kind, accel == Accel::bvh ? 30000 : 3000, 9);
            const auto one = built(primitives, {.accel = accel, .threads = 1});
            for (unsigned threads : {2u, 7u}) EXPECT_TRUE(same_built(one, built(primitives, {.accel = accel, .threads = threads})));
            // An order that an earlier structure left does not matter.
            EXPECT_TRUE(same_built(one, built(one.primitives, {.accel = accel})));
        }
}

// Every primitive once, under its own number.
void expect_complete(const Built& b) {
    std::vector<int> seen(b.primitives.size());
    for (const auto& t : b.primitives.triangles) ++seen.at(t.number);
    for (const auto& s : b.primitives.spheres) ++seen.at(s.number);
    for (const auto& s : b.primitives.shapes) ++seen.at(s.number);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(seen.size()));
}

void expect_depth(const Built& b) {
    expect_complete(b);
    EXPECT_LE(b.tables.depth, 2 * std::log2(double(b.primitives.size())) + 8); // TS-2
}

TEST(Accel, AllInOnePlace) {
    RayPrimitives primitives;
    for (int i = 0; i < 100000; ++i) add_sphere(primitives, {0.1f, 0.2f, 0.3f}, 0.5f);
    number(primitives);
    for (Accel accel : kStructures) {
        const auto b = built(primitives, {.accel = accel});
        expect_depth(b);
        EXPECT_LT(b.tables.bytes(), 30u << 20);
    }
}

TEST(Accel, SameCentersDifferentSizes) {
    RayPrimitives primitives;
    for (int i = 0; i < 3000; ++i) add_sphere(primitives, {0, 0, 0}, float(i + 1) / 3000);
    number(primitives);
    for (Accel accel : kStructures) expect_depth(built(primitives, {.accel = accel}));
    expect_same_hits(generate(Kind::overlapping, 300, 8), 4, 500);
}

// Each box holds all before it, and sizes double over and over within the range of a float.
TEST(Accel, ChainOfDoublingBoxes) {
    RayPrimitives primitives;
    for (int i = 0; i < 10000; ++i) {
        const auto size = float(std::ldexp(1.0, i % 150 - 149));
        add_triangle(primitives, {0, 0, 0}, {size, 0, 0}, {size, size, size});
    }
    number(primitives);
    for (Accel accel : kStructures) {
        const auto b = built(primitives, {.accel = accel});
        expect_depth(b);
        EXPECT_LE(b.tables.stack, 3 * 40u);
    }
}

TEST(Accel, HugeTinyAndNotFinite) {
    for (float size : {1e-38f, 1e-20f, 1e18f, 3e38f, INFINITY, NAN}) {
        RayPrimitives primitives;
        Random r(3);
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 c(r.point(1));
            if (i % 2)
                add_sphere(primitives, c * (i % 5 ? 1.0f : size), i % 3 ? 0.1f : size);
            else
                add_triangle(primitives, c, c * (i % 4 ? 0.9f : size), -c);
        }
        number(primitives);
        for (Accel accel : kStructures) expect_complete(built(primitives, {.accel = accel}));
    }
}

TEST(Accel, OctreeCountsAndLimits) {
    for (Kind kind : {Kind::spheres, Kind::clustered, Kind::slivers, Kind::coincident}) {
        const auto b = built(generate(kind, 3000, 2), {.accel = Accel::octree, .leaf = 3});
        EXPECT_EQ(b.tables.node_count % 8, 1u);
        const std::size_t inner = (b.tables.nodes[1].w - kOctreeHeaderTexels) / kOctreeNodeTexels;
        EXPECT_EQ(b.tables.node_count, 1 + 8 * inner);
        EXPECT_LE(b.tables.depth, kOctreeDepth);
    }
    const auto shallow = built(generate(Kind::spheres, 3000, 2), {.accel = Accel::octree, .leaf = 1, .depth = 2});
    EXPECT_EQ(shallow.tables.depth, 2u);
    EXPECT_EQ(shallow.tables.node_count, 73u);
}

TEST(Accel, GridHasTheCellsThatAreAsked) {
    const auto asked = built(generate(Kind::spheres, 100, 2), {.accel = Accel::grid, .cells = {3, 4, 5}});
    EXPECT_EQ(asked.tables.node_count, 60u);
    const auto chosen = built(generate(Kind::spheres, 5000, 2), {.accel = Accel::grid});
    EXPECT_GT(chosen.tables.node_count, 2 * 5000u);
    EXPECT_LT(chosen.tables.node_count, 4 * 5000u);
}

TEST(Accel, ReportsWhatItTook) {
    const auto b = built(generate(Kind::spheres, 1000, 2), {});
    EXPECT_EQ(b.tables.reference_count, 1000u);
    EXPECT_EQ(b.tables.bytes(), 16 * (b.tables.nodes.size() + b.tables.narrow.size()));
    EXPECT_GT(b.tables.narrow_inflation, 1);
    EXPECT_LT(b.tables.narrow_inflation, 1.1);
}

} // namespace
} // namespace lightbench::accel_tests
