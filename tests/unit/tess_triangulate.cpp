// Polygons into triangles: nothing lost, nothing twice, no gaps at corners on straight edges; loops that real files hold.
#include "scene/triangulate.h"
#include "tess_support.h"

#include <numbers>

namespace lightbench {
namespace {

using namespace tess;
using Loop = std::vector<glm::dvec2>;

double loop_area(const Loop& loop) { // Gauss's shoelace, in long double
    long double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
        twice += static_cast<long double>(a.x) * b.y - static_cast<long double>(a.y) * b.x;
    }
    return double(twice / 2);
}

std::vector<CornerTriple> cut(const Loop& loop) {
    std::vector<CornerTriple> triangles;
    triangulate(loop, triangles);
    return triangles;
}

double area(const Loop& loop, const CornerTriple& t) {
    return 0.5 * twice_area(loop[t[0]], loop[t[1]], loop[t[2]]);
}

// A simple loop of n corners comes to n - 2 triangles of positive area that add up: then they neither overlap nor leave anything out.
// Inner edges pair up and outer edges are the loop's own, so neighbours meet at every corner.
void expect_partition(const Loop& loop) {
    const auto triangles = cut(loop);
    EXPECT_EQ(triangles.size(), loop.size() - 2);
    double sum = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : triangles) {
        EXPECT_GT(area(loop, t), 0);
        sum += area(loop, t);
        for (int k = 0; k < 3; ++k) ++edges[{t[std::size_t(k)], t[std::size_t(k + 1) % 3]}];
    }
    EXPECT_NEAR(sum, loop_area(loop), 1e-12 * std::abs(loop_area(loop)));
    std::size_t outer = 0;
    for (const auto& [edge, uses] : edges) {
        EXPECT_EQ(uses, 1);
        if (edges.contains({edge.second, edge.first})) continue;
        ++outer;
        EXPECT_EQ(edge.second, (edge.first + 1) % loop.size());
    }
    EXPECT_EQ(outer, loop.size());
}

Loop star(std::mt19937& random, std::size_t corners) { // star-shaped, any radii: simple, mostly concave
    std::uniform_real_distribution<double> radius(0.1, 1);
    Loop loop;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(corners), r = radius(random);
        loop.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return loop;
}

Loop spiral(int turns) { // a band that winds inwards: ears are scarce
    Loop outer, inner;
    for (int i = 0; i <= 40 * turns; ++i) {
        const double angle = i * std::numbers::pi / 20, r = 1 + angle;
        outer.push_back({(r + 1) * std::cos(angle), (r + 1) * std::sin(angle)});
        inner.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

TEST(TessTriangulate, ConvexLoopsAreFans) {
    for (std::size_t n : {3u, 4u, 5u, 12u, 100u}) {
        Loop loop;
        for (std::size_t i = 0; i < n; ++i)
            loop.push_back({std::cos(6.28 * double(i) / double(n)), std::sin(6.28 * double(i) / double(n))});
        expect_partition(loop);
        for (const auto& t : cut(loop)) EXPECT_EQ(t[0], 0u);
    }
}

TEST(TessTriangulate, ConcaveLoopsArePartitioned) {
    expect_partition({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});                         // M
    expect_partition({{0, 0}, {3, 1}, {0, 2}, {1, 1}});                                 // arrow head: the wrong diagonal leaves it
    expect_partition({{3, 1}, {0, 2}, {1, 1}, {0, 0}});                                 // the same from another corner
    expect_partition({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}}); // C
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) expect_partition(star(random, 3 + std::size_t(i) % 60));
    expect_partition(spiral(5));
}

TEST(TessTriangulate, CornersOnStraightEdgesAreUsed) {
    expect_partition({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});
    expect_partition({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}});
    expect_partition({{1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}});
    Loop comb{{0, 0}};
    for (int i = 0; i <= 20; ++i) comb.push_back({double(i), i % 2 ? 1.0 : 3.0});
    comb.push_back({20, 0});
    for (int i = 19; i > 0; --i) comb.push_back({double(i), 0});
    std::reverse(comb.begin(), comb.end());
    expect_partition(comb);
}

// A square with a square hole, cut open along a bridge: two corners of the loop are met twice.
TEST(TessTriangulate, BridgedHolesKeepTheirArea) {
    const Loop loop{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    double sum = 0;
    for (const auto& t : cut(loop)) {
        EXPECT_GT(area(loop, t), 0);
        const glm::dvec2 m = (loop[t[0]] + loop[t[1]] + loop[t[2]]) / 3.0;
        EXPECT_FALSE(m.x > 1 && m.x < 3 && m.y > 1 && m.y < 3) << "a triangle in the hole";
        sum += area(loop, t);
    }
    EXPECT_DOUBLE_EQ(sum, 12);
}

TEST(TessTriangulate, LoopsThatCrossThemselvesEndAndKeepTheSignedArea) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    for (int i = 0; i < 300; ++i) {
        Loop loop;
        for (int k = 0; k < 4 + i % 20; ++k) loop.push_back({anywhere(random), anywhere(random)});
        double sum = 0;
        for (const auto& t : cut(loop)) sum += area(loop, t);
        EXPECT_NEAR(sum, loop_area(loop), 1e-13 * double(loop.size()));
    }
    Loop pentagram;
    for (int i = 0; i < 5; ++i) pentagram.push_back({std::cos(4 * i * std::numbers::pi / 5), std::sin(4 * i * std::numbers::pi / 5)});
    EXPECT_FALSE(strictly_convex(pentagram));
    EXPECT_TRUE(cut({{0, 0}, {1, 0}, {2, 0}, {3, 0}}).empty());
}

TEST(TessTriangulate, LargeLoopsEndSoon) {
    std::mt19937 random(3);
    Loop comb{{0, 0}, {20000, 0}};
    for (int i = 20000; i >= 0; --i) comb.push_back({double(i), i % 2 ? 1.0 : 3.0});
    for (const Loop& loop : {star(random, 40000), spiral(400), comb}) {
        double sum = 0;
        for (const auto& t : cut(loop)) sum += area(loop, t);
        EXPECT_NEAR(sum, loop_area(loop), 1e-9 * loop_area(loop));
    }
    std::uniform_real_distribution<double> anywhere(-1, 1);
    Loop tangle;
    for (int i = 0; i < 20000; ++i) tangle.push_back({anywhere(random), anywhere(random)});
    double sum = 0;
    for (const auto& t : cut(tangle)) sum += area(tangle, t);
    EXPECT_NEAR(sum, loop_area(tangle), 1e-9);
}

TEST(TessTriangulate, ObjectsKeepTheirAreaInEveryDirection) {
    for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0.1, 0), glm::dvec3(-1, -2, -3), glm::dvec3(0, -1, 1)}) {
        const glm::dvec3 n = glm::normalize(normal), u = glm::normalize(glm::cross(n, glm::dvec3(0.3, 0.5, 0.8))), v = glm::cross(n, u);
        Polygon arrow;
        for (const glm::dvec2& p :
             {glm::dvec2(0, 0), glm::dvec2(3, 1), glm::dvec2(0, 2), glm::dvec2(1, 1), glm::dvec2(1, 1), glm::dvec2(0, 0)})
            arrow.points.push_back(p.x * u + p.y * v);
        const auto g = tessellate(scene_of({arrow}), {});
        expect_sound(g);
        expect_provoked_in_plane(g);
        EXPECT_EQ(g.indices.size(), 6u);
        EXPECT_NEAR(area_of(g), 2, 1e-6);
        EXPECT_LE(glm::distance(glm::dvec3(g.polygons.normals[0].normal), n), 1e-7);
        const glm::dvec3 center = (2.0 * v + u + v + 3.0 * u + v) / 4.0;
        EXPECT_LE(glm::distance(glm::dvec3(g.polygons.positions[0].position) / g.frame.scale + g.frame.origin, center), 1e-6)
            << "repeated points count once";
    }
}

} // namespace
} // namespace lightbench
