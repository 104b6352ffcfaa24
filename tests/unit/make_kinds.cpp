// Procedural scenes against closed forms: counts, tangency, published coordinates, the geometry that makes each failure of shading happen.
#include "scene/limits.h"
#include "scene/make.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>

using namespace lightbench;

namespace {

Scene made(std::string_view kind, const MakeArguments& arguments = {}) {
    auto result = make_scene(kind, arguments);
    if (const auto* problems = std::get_if<Problems>(&result)) ADD_FAILURE() << to_string(problems->front());
    return std::holds_alternative<Scene>(result) ? std::get<Scene>(result) : Scene{};
}

template <typename S> std::vector<S> shapes(const Scene& scene) {
    std::vector<S> found;
    for (const Object& o : scene.objects)
        if (const S* s = std::get_if<S>(&o.shape)) found.push_back(*s);
    return found;
}

std::array<double, 4> numbers(const Sphere& s) {
    return {s.center.x, s.center.y, s.center.z, s.radius};
}

glm::dvec3 newell(const std::vector<glm::dvec3>& p) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 a = p[i], b = p[(i + 1) % p.size()];
        sum += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    return sum;
}

std::vector<glm::dvec3> face_points(const Mesh& m, std::size_t f) {
    std::vector<glm::dvec3> points;
    for (std::uint32_t c = m.face_starts[f]; c < m.face_starts[f + 1]; ++c) points.emplace_back(m.positions[m.corners[c]]);
    return points;
}

// Vertex normals by definition: the angle-weighted mean of the faces around (Thuermer and Wuethrich 1998), every edge smoothed over.
std::vector<glm::dvec3> averaged_normals(const Mesh& m) {
    std::vector<glm::dvec3> sums(m.positions.size(), glm::dvec3(0));
    for (std::size_t f = 0; f < m.face_count(); ++f) {
        const auto p = face_points(m, f);
        const glm::dvec3 n = glm::normalize(newell(p));
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 a = glm::normalize(p[(i + 1) % p.size()] - p[i]), b = glm::normalize(p[(i + p.size() - 1) % p.size()] - p[i]);
            sums[m.corners[m.face_starts[f] + i]] += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * n;
        }
    }
    for (glm::dvec3& n : sums) n = glm::normalize(n);
    return sums;
}

} // namespace

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

// The corners as Cornell publishes them (metric data of the box, millimetres).
TEST(Make, CornellBoxIsThePublishedOne) {
    const std::vector<std::vector<glm::dvec3>> published = {
        {{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}},
        {{556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}},
        {{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556, 548.8, 559.2}},
        {{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}},
        {{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}},
        {{290, 0, 114}, {290, 165, 114}, {240, 165, 272}, {240, 0, 272}},
        {{130, 0, 65}, {130, 165, 65}, {290, 165, 114}, {290, 0, 114}},
        {{82, 0, 225}, {82, 165, 225}, {130, 165, 65}, {130, 0, 65}},
        {{240, 0, 272}, {240, 165, 272}, {82, 165, 225}, {82, 0, 225}},
        {{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}},
        {{423, 0, 247}, {423, 330, 247}, {472, 330, 406}, {472, 0, 406}},
        {{472, 0, 406}, {472, 330, 406}, {314, 330, 456}, {314, 0, 456}},
        {{314, 0, 456}, {314, 330, 456}, {265, 330, 296}, {265, 0, 296}},
        {{265, 0, 296}, {265, 330, 296}, {423, 330, 247}, {423, 0, 247}},
        {{343, 548.7, 227}, {343, 548.7, 332}, {213, 548.7, 332}, {213, 548.7, 227}},
        {{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}},
        {{552.8, 0, 0}, {556, 548.8, 559.2}, {556, 548.8, 0}},
    };
    const Scene scene = made("cornell-box");
    const auto polygons = shapes<Polygon>(scene);
    ASSERT_EQ(polygons.size(), published.size());
    // The same corners in the same turn, whichever comes first.
    const auto same = [](const std::vector<glm::dvec3>& a, std::vector<glm::dvec3> b) {
        for (std::size_t i = 0; i < b.size(); ++i, std::rotate(b.begin(), b.begin() + 1, b.end()))
            if (a == b) return true;
        return false;
    };
    for (const auto& quad : published)
        EXPECT_EQ(std::count_if(polygons.begin(), polygons.end(), [&](const Polygon& p) { return same(quad, p.points); }), 1)
            << quad[0].x << " " << quad[0].y << " " << quad[0].z;
    EXPECT_NEAR(scene.cameras[0].fov, 39.307648 * std::numbers::pi / 180, 1e-8);
    EXPECT_EQ(scene.cameras[0].position, glm::dvec3(278, 273, -800));
    EXPECT_EQ(made("cornell-box", {{"point_light", "0"}}).lights.size(), 0u);
}

// Walls and lamp face into the box, the sides of a block away from its middle.
TEST(Make, CornellBoxFacesItsInside) {
    const auto polygons = shapes<Polygon>(made("cornell-box"));
    const auto faces = [&](std::size_t i, const glm::dvec3& p) {
        return glm::dot(newell(polygons.at(i).points), p - polygons[i].points[0]) > 0;
    };
    for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(faces(i, {278, 400, 280})) << "wall " << i;
    for (std::size_t i = 6; i < 11; ++i) EXPECT_FALSE(faces(i, {185, 80, 169})) << "short block, side " << i;
    for (std::size_t i = 11; i < 16; ++i) EXPECT_FALSE(faces(i, {368, 160, 351})) << "tall block, side " << i;
    EXPECT_TRUE(faces(16, {278, 400, 280})) << "lamp";
}

TEST(Make, CorrugatedNormalsAreParallelUnlessCut) {
    const Scene flat = made("corrugated", {{"ridges", "9"}, {"slope", "35"}});
    const auto n = averaged_normals(flat.meshes.at(0));
    ASSERT_EQ(n.size(), 2u * (2 * 9 + 1));
    for (std::size_t i = 2; i + 2 < n.size(); ++i) EXPECT_LT(glm::distance(n[i], glm::dvec3(0, 1, 0)), 1e-6) << i;
    for (std::size_t f = 0; f < flat.meshes[0].face_count(); ++f)
        EXPECT_NEAR(glm::normalize(newell(face_points(flat.meshes[0], f))).y, std::cos(35 * std::numbers::pi / 180), 1e-6);
    EXPECT_GT(flat.objects.at(0).crease, 70 * std::numbers::pi / 180) << "a crease angle below the edges would hide the failure";
    const auto cut = averaged_normals(made("corrugated", {{"ridges", "9"}, {"slope", "35"}, {"subdivide", "2"}}).meshes.at(0));
    double least = 1;
    for (const glm::dvec3& v : cut) least = std::min(least, v.y);
    EXPECT_LT(least, 0.83); // cos 35 degrees is 0.819
}

// R.V^n by hand: full in the middle, nothing at the vertices.
TEST(Make, HighlightIsInTheMiddleAndNowhereElse) {
    const Scene scene = made("highlight");
    const auto points = shapes<Polygon>(scene).at(0).points;
    const auto highlight = [&](const glm::dvec3& p) {
        const glm::dvec3 n(0, 1, 0), l = glm::normalize(scene.lights[0].position - p), v = glm::normalize(scene.cameras[0].position - p);
        return std::pow(std::max(0.0, glm::dot(2 * glm::dot(n, l) * n - l, v)), static_cast<double>(scene.materials[0].shininess));
    };
    EXPECT_GT(highlight((points[0] + points[1] + points[2]) / 3.0), 0.999);
    for (const glm::dvec3& p : points) EXPECT_LT(highlight(p), 1e-3);
}

TEST(Make, CreaseBodiesAreClosedAndFaceOutwards) {
    for (const Mesh& m : made("crease").meshes) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        double volume = 0; // sixfold
        for (std::size_t f = 0; f < m.face_count(); ++f) {
            const auto p = face_points(m, f);
            for (std::size_t i = 1; i + 1 < p.size(); ++i) volume += glm::dot(p[0], glm::cross(p[i], p[i + 1]));
            for (std::uint32_t c = m.face_starts[f]; c < m.face_starts[f + 1]; ++c)
                ++edges[{m.corners[c], m.corners[c + 1 == m.face_starts[f + 1] ? m.face_starts[f] : c + 1]}];
        }
        EXPECT_GT(volume, 0) << m.name;
        for (const auto& [edge, uses] : edges) {
            EXPECT_EQ(uses, 1) << m.name;
            EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << m.name << ": an open edge";
        }
    }
}

// The intensity of a vertex is the cosine of its normal's tilt: the bars of the third body carry what lies on the outline.
TEST(Make, ScanLinesOfAQuadFollowItsOutline) {
    for (const double turn : {0.0, 30.0, 45.0}) {
        const Scene scene = made("quads", {{"turn", std::to_string(turn)}});
        ASSERT_EQ(scene.meshes.size(), 3u);
        const Mesh& split = scene.meshes[0];
        const Mesh& bars = scene.meshes[2];
        ASSERT_EQ(split.face_count(), 2u);
        for (std::size_t v = 0; v + 3 < bars.positions.size(); v += 4) {
            const glm::dvec2 left = 0.5 * (glm::dvec2(bars.positions[v]) + glm::dvec2(bars.positions[v + 3])) - glm::dvec2(3.2, 0);
            double nearest = 1e9, intensity = 0;
            for (std::size_t e = 0; e < 4; ++e) { // the edge of the outline that the end lies on
                const std::size_t a = e, b = (e + 1) % 4;
                const glm::dvec2 p = glm::dvec2(split.positions[a]) + glm::dvec2(3.2, 0),
                                 d = glm::dvec2(split.positions[b]) + glm::dvec2(3.2, 0) - p;
                const double u = glm::dot(left - p, d) / glm::dot(d, d), away = glm::distance(left, p + u * d);
                if (u < 0 || u > 1 || away > nearest) continue;
                nearest = away, intensity = glm::mix(double(split.normals[a].z), double(split.normals[b].z), u);
            }
            EXPECT_LT(nearest, 1e-6) << turn << ": bar " << v / 4;
            EXPECT_NEAR(bars.normals[v].z, intensity, 1e-6) << turn << ": bar " << v / 4;
        }
    }
}

TEST(Make, MeshIsClosedOutwardsAndOfTheSizeAsked) {
    for (const std::size_t k : {1u, 2u, 7u}) {
        const Mesh m = made("mesh", {{"triangles", std::to_string(12 * k * k)}}).meshes.at(0);
        EXPECT_EQ(m.face_count(), 12 * k * k);
        EXPECT_EQ(m.positions.size(), 6 * k * k + 2);
        EXPECT_EQ(std::set<std::uint32_t>(m.corners.begin(), m.corners.end()).size(), m.positions.size());
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (std::size_t f = 0; f < m.face_count(); ++f) {
            const std::uint32_t* c = &m.corners[3 * f];
            for (int i = 0; i < 3; ++i) EXPECT_TRUE(edges.insert({c[i], c[(i + 1) % 3]}).second);
            const auto p = face_points(m, f);
            EXPECT_GT(glm::dot(newell(p), p[0] + p[1] + p[2]), 0) << "face " << f << " looks inwards";
        }
        for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u);
    }
    EXPECT_EQ(made("mesh").meshes.at(0).face_count(), 1'002'252u); // 12 * 289^2, the nearest to a million
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

// Points that the control points fix: tip of the knob, rims, the body's widest ring (2 m, at 0.9), tip of the spout, back of the handle.
TEST(Make, TeapotIsNewells) {
    for (const char* pieces : {"1", "2", "8", "16"}) {
        const Scene scene = made("teapot", {{"pieces", pieces}});
        const Mesh& m = scene.meshes.at(0);
        const auto p = static_cast<std::size_t>(std::atoi(pieces));
        EXPECT_EQ(m.face_count(), 32 * p * p) << "32 patches";
        const auto has = [&](const glm::vec3& point) {
            return std::any_of(m.positions.begin(), m.positions.end(), [&](const glm::vec3& q) { return glm::distance(q, point) < 1e-6f; });
        };
        for (const glm::vec3& point : {glm::vec3(0, 3.15f, 0),
                                       {0.2f, 2.7f, 0},
                                       {0, 2.4f, 1.3f},
                                       {-1.4f, 2.4f, 0},
                                       {0, 2.4f, -1.5f},
                                       {2, 0.9f, 0},
                                       {-1.5f, 0.15f, 0},
                                       {0, 0, 0},
                                       {-1.6f, 2.025f, 0},
                                       {-3, 1.8f, 0},
                                       {-2.7f, 1.8f, 0},
                                       {1.7f, 0.6f, 0},
                                       {3.3f, 2.4f, 0},
                                       {3.2f, 2.4f, 0},
                                       {2.8f, 2.4f, 0}})
            EXPECT_TRUE(has(point)) << point.x << " " << point.y << " " << point.z;
    }
    EXPECT_EQ(made("teapot").materials.at(0).environment, 1.0f);
}

// Lid and pot hold a positive volume, handle and spout face away from their own middles, but for the lip of the spout: that turns inwards.
TEST(Make, TeapotFacesOutwards) {
    const Mesh m = made("teapot", {{"pieces", "8"}}).meshes.at(0);
    const std::size_t turned = 24 * 64;
    double volume = 0; // of the lid and the pot, each closed by a disc at 2.4: the discs add r^2 pi 2.4 / 3 with both signs
    for (std::size_t f = 0; f < turned; ++f) {
        const auto p = face_points(m, f);
        for (std::size_t i = 1; i + 1 < p.size(); ++i) volume += glm::dot(p[0], glm::cross(p[i], p[i + 1])) / 6;
    }
    EXPECT_GT(volume, 15);
    for (std::size_t f = turned; f < turned + 28 * 16; ++f) {
        const std::size_t row = (f - turned) / 16; // 16 faces around make a ring of a tube
        glm::dvec3 middle(0), center(0);
        for (std::size_t i = 0; i < 16; ++i)
            for (const glm::dvec3& q : face_points(m, turned + row * 16 + i)) middle += q / 64.0;
        const auto p = face_points(m, f);
        for (const glm::dvec3& q : p) center += q / double(p.size());
        EXPECT_GT(glm::dot(newell(p), center - middle), 0) << f;
    }
}

TEST(Make, MetalsStandBesideTheirPaint) {
    const Scene scene = made("metals", {{"rows", "3"}, {"smoothest", "0.1"}, {"roughest", "0.4"}});
    const auto balls = shapes<Sphere>(scene);
    ASSERT_EQ(balls.size(), 24u);
    for (std::size_t i = 0; i < balls.size(); i += 2) {
        const Material &metal = scene.materials[scene.objects[i].material], &paint = scene.materials[scene.objects[i + 1].material];
        EXPECT_EQ(metal.model, Model::cook_torrance);
        EXPECT_EQ(paint.model, Model::phong);
        EXPECT_FLOAT_EQ(metal.roughness, 0.1f * std::pow(2.0f, static_cast<float>(i / 8)));
        EXPECT_EQ(paint.name, "painted-" + metal.name);
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(metal.f0->operator[](k) > 0.3f && metal.f0->operator[](k) < 1);
        EXPECT_NEAR(paint.shininess, 0.5f / (metal.roughness * metal.roughness) - 0.5f, 1e-3);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(glm::distance(balls[i].center, balls[j].center), balls[i].radius + balls[j].radius) << "they do not touch";
    }
}

TEST(Make, PanesOverlapOutOfOrder) {
    for (const char* n : {"1", "2", "7", "1000"}) {
        const Scene scene = made("panes", {{"n", n}, {"opacity", "0.25"}});
        auto polygons = shapes<Polygon>(scene);
        ASSERT_EQ(polygons.size(), static_cast<std::size_t>(std::atoi(n)) + 1) << "and the wall";
        std::set<double> depths;
        std::size_t ascents = 0;
        for (std::size_t i = 1; i < polygons.size(); ++i) {
            for (const glm::dvec3& p : polygons[i].points) EXPECT_EQ(p.z, polygons[i].points[0].z);
            EXPECT_TRUE(depths.insert(polygons[i].points[0].z).second) << "two panes at one depth";
            ascents += i > 1 && polygons[i].points[0].z > polygons[i - 1].points[0].z;
            const glm::vec3 opacity = scene.materials[scene.objects[i].material].opacity;
            EXPECT_TRUE(opacity.r >= 0.125f && opacity.r <= 0.25f) << opacity.r;
        }
        EXPECT_GT(*depths.begin(), -2) << "in front of the wall";
        if (polygons.size() > 100) {
            EXPECT_TRUE(ascents > 300 && ascents < 700) << ascents << " of 999: hardly sorted";
        }
    }
    EXPECT_NE(shapes<Polygon>(made("panes", {{"tilt", "30"}})).at(5).points[0].z,
              shapes<Polygon>(made("panes", {{"tilt", "30"}})).at(5).points[2].z);
}
