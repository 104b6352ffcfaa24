// Procedural scenes against closed forms: counts, tangency, ranges of parameters.
#include "scene/limits.h"
#include "unit/make_support.h"

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <numbers>
#include <set>

using namespace lightbench;
using namespace lightbench::make_test;

TEST(Make, EveryKindIsSound) {
    for (const MakeKind& kind : make_kinds()) {
        SCOPED_TRACE(kind.name);
        const Scene scene = made(kind.name);
        EXPECT_FALSE(kind.description.empty());
        EXPECT_EQ(scene.name, kind.name);
        EXPECT_FALSE(scene.cameras.empty());
        EXPECT_FALSE(scene.lights.empty());
        EXPECT_FALSE(scene.objects.empty());
        std::set<std::string> names;
        for (const Material& m : scene.materials) EXPECT_TRUE(names.insert(m.name).second) << "two materials are called " << m.name;
        for (const Object& o : scene.objects) {
            ASSERT_LT(o.material, scene.materials.size());
            ASSERT_LT(o.transform, scene.transforms.size());
        }
        for (const MeshUse& use : shapes<MeshUse>(scene)) ASSERT_LT(use.mesh, scene.meshes.size());
        for (const Polygon& p : shapes<Polygon>(scene)) {
            const glm::dvec3 n = glm::normalize(newell(p.points));
            for (const glm::dvec3& q : p.points) EXPECT_NEAR(glm::dot(n, q - p.points[0]), 0, 1e-9) << "a polygon is not planar";
        }
        for (const Mesh& m : scene.meshes) {
            ASSERT_EQ(m.face_starts.back(), m.corners.size());
            EXPECT_LT(*std::max_element(m.corners.begin(), m.corners.end()), m.positions.size());
        }
    }
}

TEST(Make, DefaultsLieWithinTheirRanges) {
    for (const MakeKind& kind : make_kinds())
        for (const MakeParameter& p : kind.parameters) {
            EXPECT_LE(p.min, p.default_value) << kind.name << " " << p.name;
            EXPECT_GE(p.max, p.default_value) << kind.name << " " << p.name;
            EXPECT_FALSE(p.meaning.empty());
        }
}

// Every parameter at both ends of its range, where that is cheap.
TEST(Make, EndsOfRangesAreAccepted) {
    for (const MakeKind& kind : make_kinds())
        for (const MakeParameter& p : kind.parameters) {
            SCOPED_TRACE(std::string(kind.name) + " " + std::string(p.name));
            made(kind.name, {{std::string(p.name), std::to_string(p.min)}});
            if (p.max <= 10000 && p.name != "depth") made(kind.name, {{std::string(p.name), std::to_string(p.max)}});
        }
}

TEST(Make, SphereflakeCountsAndTouches) {
    for (std::size_t depth = 0, expected = 1, generation = 1; depth <= 4; ++depth, generation *= 9, expected += generation) {
        const Scene scene = made("sphereflake", {{"depth", std::to_string(depth)}});
        const auto balls = shapes<Sphere>(scene);
        ASSERT_EQ(balls.size(), expected);
        ASSERT_EQ(shapes<Polygon>(scene).size(), 1u);
    }
    // Children follow their parent in the list (each before its own children): the last ball of the next larger size is the parent.
    const auto balls = shapes<Sphere>(made("sphereflake", {{"depth", "4"}}));
    std::map<int, Sphere> open;
    std::map<int, int> children;
    for (const Sphere& ball : balls) {
        const int level = static_cast<int>(std::lround(std::log(0.5 / ball.radius) / std::log(3.0)));
        EXPECT_NEAR(ball.radius, 0.5 / std::pow(3.0, level), 1e-15);
        if (level > 0) {
            const Sphere& parent = open.at(level - 1);
            EXPECT_NEAR(glm::distance(ball.center, parent.center), parent.radius + ball.radius, 1e-14);
            ++children[level];
        }
        open[level] = ball;
    }
    EXPECT_EQ(children[4], 6561);
}

// A rotation that is nearly, but not quite, opposite to +Z would lose digits: there must be none between rounding and 1e-5 radians.
TEST(Make, SphereflakeHasNoNearlyDownwardChild) {
    std::map<int, Sphere> open;
    double nearest = 2, rounding = 0;
    for (const Sphere& ball : shapes<Sphere>(made("sphereflake", {{"depth", "6"}}))) {
        const int level = static_cast<int>(std::lround(std::log(0.5 / ball.radius) / std::log(3.0)));
        if (level > 0) {
            const glm::dvec3 d = (ball.center - open.at(level - 1).center) / (ball.radius * 4);
            const double off = std::hypot(d.x, d.y);
            if (d.z < 0) (off < 1e-10 ? rounding : nearest) = off < 1e-10 ? std::max(rounding, off) : std::min(nearest, off);
        }
        open[level] = ball;
    }
    EXPECT_GT(nearest, 1e-5);
    EXPECT_LT(rounding, 1e-12); // centres are rounded to 1e-16 of 1, and divided here by a radius of 1e-3
}

// Does some ball of ours print as this one of Haines does? Half a unit of the sixth digit.
bool prints_as(const Sphere& ours, const std::array<double, 4>& his) {
    for (std::size_t k = 0; k < 4; ++k)
        if (std::fabs(numbers(ours)[k] - his[k]) > 0.51e-5 * std::max(0.1, std::fabs(his[k]))) return false;
    return true;
}

// Every six-hundredth ball of Haines' file balls_4.nff (SPD, CC0).
TEST(Make, SphereflakeHoldsSomeOfHainesBalls) {
    const std::vector<std::array<double, 4>> his = {
        {0.45787, 0.475329, 0.577669, 0.00617284},     {0.31322, 0.188347, 0.771198, 0.00617284},
        {0.671225, 0.356956, 0.0987654, 0.00617284},   {0.359921, 0.517056, -0.0987654, 0.00617284},
        {0.372813, 0.60307, 0.187336, 0.00617284},     {-0.551799, -0.0449178, 0.438769, 0.00617284},
        {-0.640408, 0.498776, -0.15987, 0.0185185},    {-0.5724, -0.153374, 0.197531, 0.00617284},
        {-0.609969, -0.394768, -0.178389, 0.00617284}, {-0.140792, -0.380859, 0.599887, 0.00617284},
        {-0.095832, -0.700504, 0.222222, 0.00617284},  {0.703286, -0.447429, 0.0462858, 0.00617284},
        {0.273047, -0.652302, -0.125608, 0.00617284}};
    const auto ours = shapes<Sphere>(made("sphereflake"));
    for (const auto& ball : his)
        EXPECT_EQ(std::count_if(ours.begin(), ours.end(), [&](const Sphere& s) { return prints_as(s, ball); }), 1)
            << ball[0] << " " << ball[1];
}

// The whole file, where it is at hand: the same balls, each exactly once, in any order.
TEST(Make, SphereflakeEqualsHainesBalls) {
    const char* folder = std::getenv("LIGHTBENCH_SPD");
    std::ifstream file(std::string(folder ? folder : LIGHTBENCH_SOURCE "/../shared/scenes") + "/balls_4.nff");
    if (!file) GTEST_SKIP() << "LIGHTBENCH_SPD does not name a folder with balls_4.nff";
    // Cells of 1e-4, so that each of his is looked for in 27 cells and not in 7 381 balls.
    std::multimap<std::array<long, 3>, Sphere> cells;
    const auto cell = [](double x, double y, double z) {
        return std::array{std::lround(x * 1e4), std::lround(y * 1e4), std::lround(z * 1e4)};
    };
    for (const Sphere& s : shapes<Sphere>(made("sphereflake"))) cells.emplace(cell(s.center.x, s.center.y, s.center.z), s);
    std::size_t count = 0;
    for (std::string line; std::getline(file, line);) {
        std::array<double, 4> his;
        if (std::sscanf(line.c_str(), "s %lf %lf %lf %lf", &his[0], &his[1], &his[2], &his[3]) != 4) continue;
        ++count;
        auto found = cells.end();
        for (int i = 0; i < 27 && found == cells.end(); ++i) {
            const auto c = cell(his[0], his[1], his[2]);
            const auto [first, last] = cells.equal_range({c[0] + i % 3 - 1, c[1] + i / 3 % 3 - 1, c[2] + i / 9 - 1});
            const auto match = std::find_if(first, last, [&](const auto& entry) { return prints_as(entry.second, his); });
            if (match != last) found = match;
        }
        ASSERT_NE(found, cells.end()) << line;
        cells.erase(found);
    }
    EXPECT_EQ(count, 7381u);
    EXPECT_TRUE(cells.empty());
}

TEST(Make, RoomsFaceInwards) {
    for (const char* kind : {"room", "mirrors"}) {
        const Scene scene = made(kind);
        const auto walls = shapes<Polygon>(scene);
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_GT(glm::dot(newell(walls.at(i).points), scene.cameras[0].position - walls[i].points[0]), 0) << kind << " wall " << i;
        double area = 0; // closed: the area vectors of the walls add up to nothing
        glm::dvec3 sum(0);
        for (std::size_t i = 0; i < 6; ++i) sum += newell(walls[i].points), area += glm::length(newell(walls[i].points));
        EXPECT_LT(glm::length(sum), 1e-12 * area);
    }
    EXPECT_EQ(made("room").materials.at(0).two_sided, true);
}

TEST(Make, SpheresStandApart) {
    const auto balls = shapes<Sphere>(made("spheres", {{"n", "126"}})); // one more than 5^3: a grid of six a side
    ASSERT_EQ(balls.size(), 126u);
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) ASSERT_GT(glm::distance(balls[i].center, balls[k].center), balls[i].radius + balls[k].radius);
    EXPECT_NEAR(balls[1].center.x - balls[0].center.x, 2.0 / 6, 1e-12);
    EXPECT_EQ(shapes<Sphere>(made("spheres", {{"n", "125"}})).at(1).center.x,
              shapes<Sphere>(made("spheres", {{"n", "101"}})).at(1).center.x);
}

TEST(Make, LightsAreAsManyAsAskedAndAsBrightInAll) {
    for (const char* n : {"1", "100", "1000"}) {
        const Scene scene = made("lights", {{"n", n}});
        EXPECT_EQ(scene.lights.size(), std::stoul(n));
        glm::dvec3 sum(0);
        for (const Light& l : scene.lights) sum += glm::dvec3(l.intensity);
        EXPECT_NEAR(std::max({sum.x, sum.y, sum.z}), 6, 3) << n;
    }
}

TEST(Make, PrimitivesHoldOneOfEach) {
    std::set<std::size_t> kinds;
    for (const Object& o : made("primitives").objects) kinds.insert(o.shape.index());
    EXPECT_EQ(kinds.size(), std::variant_size_v<Shape>);
    std::set<LightType> types;
    std::set<Attenuation> laws;
    for (const Light& l : made("primitives").lights) types.insert(l.type), laws.insert(l.attenuation);
    EXPECT_EQ(types.size(), 3u);
}

TEST(Make, HueGoesAround) {
    const Scene scene = made("spheres", {{"n", "1"}});
    std::set<std::array<float, 3>> colors;
    for (std::size_t i = 0; i < 12; ++i) {
        const glm::vec3 c = scene.materials.at(i).diffuse;
        EXPECT_FLOAT_EQ(std::max({c.r, c.g, c.b}), 0.8f);
        EXPECT_FLOAT_EQ(std::min({c.r, c.g, c.b}), 0.32f);
        colors.insert({c.r, c.g, c.b});
    }
    EXPECT_EQ(colors.size(), 12u);
    EXPECT_FLOAT_EQ(scene.materials[0].diffuse.r, 0.8f); // red, green, blue in this order
    EXPECT_FLOAT_EQ(scene.materials[4].diffuse.g, 0.8f);
    EXPECT_FLOAT_EQ(scene.materials[8].diffuse.b, 0.8f);
}
