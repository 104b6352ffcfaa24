// Values at corners: constants stay, planes are met, nothing passes creases, nothing is negative (HARD_CASES VX-1 to VX-4).
#include "patches_support.h"
#include "radiosity/reconstruct.h"

#include <cmath>

namespace lightbench {
namespace {

using namespace patches_test;
using make_test::made;
using tess::scene_of;

Scene one_sided(std::vector<Shape> shapes) {
    Scene scene = scene_of(std::move(shapes));
    scene.materials[0].two_sided = false;
    return scene;
}

Scene square() {
    return one_sided({polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})});
}

template <typename F> std::vector<glm::vec3> values_of(const PatchMesh& m, F f) {
    std::vector<glm::vec3> values;
    for (const Element& e : m.elements) values.push_back(f(e.center));
    return values;
}

double ulps(float a, double b) {
    return std::abs(double(a) - b) / (std::nextafter(std::abs(float(b)), INFINITY) - std::abs(float(b)));
}

TEST(CornerValues, KeepAConstant) {
    for (const Scene& scene : {made("cornell-box"), made("teapot"), scene_of({Sphere{}, Cylinder{{3, 0, 0}, {3, 1, 0}, 0.5, true}})}) {
        const PatchMesh m = make_patches(scene, {.elements = 2000});
        const glm::vec3 constant(0.1f, 1.0f / 3, 1e20f);
        const auto corners = corner_values(m, std::vector<glm::vec3>(m.elements.size(), constant));
        for (std::size_t e = 0; e < m.elements.size(); ++e)
            for (std::size_t i = 0; i < m.elements[e].size() && !m.elements[e].covered; ++i)
                for (int c = 0; c < 3; ++c) ASSERT_LE(ulps(corners[e][i][c], constant[c]), 1) << e;
    }
}

TEST(CornerValues, MeetAPlaneOnAGrid) {
    const PatchMesh m = make_patches(square(), {.element = 1.0 / 9});
    const auto plane = [](const glm::dvec3& p) { return glm::vec3(3.0 + p.x, 3.0 + 0.7 * p.x - 0.4 * p.y, 2.0 + p.y); };
    const auto corners = corner_values(m, values_of(m, plane));
    for (std::size_t e = 0; e < m.elements.size(); ++e)
        for (std::size_t i = 0; i < 4; ++i)
            for (int c = 0; c < 3; ++c) EXPECT_LE(ulps(corners[e][i][c], plane(m.points[m.elements[e].corners[i]])[c]), 4) << e << " " << i;
}

TEST(CornerValues, MeetAPlaneOnTheBorderOfTriangles) {
    const PatchMesh m =
        make_patches(one_sided({polygon({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}})}), {.element = 0.3});
    const auto plane = [](const glm::dvec3& p) { return glm::vec3(float(5 + p.x), float(5 - 0.5 * p.y), 5); };
    const auto corners = corner_values(m, values_of(m, plane));
    for (std::size_t e = 0; e < m.elements.size(); ++e)
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3 wanted = plane(m.points[m.elements[e].corners[i]]);
            EXPECT_NEAR(corners[e][i].x, wanted.x, 0.03) << "inside it is the mean of what is around";
        }
}

TEST(CornerValues, AreGoralsFormulas) {
    const PatchMesh m = make_patches(square(), {.element = 0.5});
    ASSERT_EQ(m.elements.size(), 4u);
    const std::vector<glm::vec3> values = {glm::vec3(1), glm::vec3(2), glm::vec3(4), glm::vec3(9)};
    const auto corners = corner_values(m, values);
    const auto at = [&](double x, double y) {
        for (std::size_t e = 0; e < 4; ++e)
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec3 p = m.points[m.elements[e].corners[i]] / m.frame.scale + m.frame.origin;
                if (glm::distance(p, {x, y, 0}) < 1e-9) return corners[e][i].x;
            }
        return -1.0f;
    };
    EXPECT_EQ(at(0.5, 0.5), 4) << "(B1 + B2 + B3 + B4) / 4";
    EXPECT_EQ(at(0.5, 0), 0) << "B1 + B2 - BE = -1, and never negative";
    EXPECT_EQ(at(0.5, 1), 9) << "B3 + B4 - BE";
    EXPECT_EQ(at(1, 1), 14) << "2 B4 - BE";
    EXPECT_EQ(at(0, 1), 4) << "2 B3 - BE";
}

TEST(CornerValues, StayOnTheirSideOfACrease) {
    const PatchMesh m = make_patches(scene_of({Box{}}), {.element = 0.25});
    std::vector<glm::vec3> values;
    for (const Element& e : m.elements) values.push_back(glm::vec3(float(e.group + 1)));
    const auto corners = corner_values(m, values);
    for (std::size_t e = 0; e < m.elements.size(); ++e)
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(corners[e][i], values[e]);
}

TEST(CornerValues, OfSingleRowsAreMeans) {
    const PatchMesh single = make_patches(square(), {.element = 2});
    ASSERT_EQ(single.elements.size(), 1u);
    const auto alone = corner_values(single, std::vector{glm::vec3(7)});
    for (const glm::vec3& corner : alone[0]) EXPECT_EQ(corner, glm::vec3(7));
    const PatchMesh row = make_patches(one_sided({polygon({{0, 0, 0}, {5, 0, 0}, {5, 1, 0}, {0, 1, 0}})}), {.element = 1});
    ASSERT_EQ(row.elements.size(), 5u);
    const auto corners =
        corner_values(row, values_of(row, [&](const glm::dvec3& p) { return glm::vec3(float(10 + p.x / row.frame.scale)); }));
    EXPECT_FLOAT_EQ(corners[0][0].x, 8);
    EXPECT_FLOAT_EQ(corners[0][1].x, 8.5);
    EXPECT_FLOAT_EQ(corners[4][1].x, 12);
    EXPECT_TRUE(corner_values(make_patches(Scene{}, {}), {}).empty());
}

TEST(CornerValues, OfCornersOfOnePointAndGroupAreOne) {
    const PatchMesh m = make_patches(made("teapot"), {.elements = 20000});
    std::vector<glm::vec3> values;
    for (std::size_t e = 0; e < m.elements.size(); ++e) values.push_back(glm::vec3(float((e * 2654435761u) % 1000)));
    const auto corners = corner_values(m, values);
    std::map<std::pair<std::uint32_t, std::uint32_t>, glm::vec3> known;
    for (std::size_t e = 0; e < m.elements.size(); ++e)
        for (std::size_t i = 0; i < m.elements[e].size(); ++i) {
            EXPECT_GE(corners[e][i].x, 0);
            const auto [at, fresh] = known.try_emplace({m.elements[e].corners[i], m.elements[e].group}, corners[e][i]);
            if (!fresh) {
                EXPECT_EQ(at->second, corners[e][i]);
            }
        }
}

TEST(CornerValues, LeaveOutWhatIsCovered) {
    PatchMesh m = make_patches(square(), {.element = 0.1});
    std::vector<glm::vec3> values(m.elements.size(), glm::vec3(3));
    for (std::size_t e = 0; e < m.elements.size(); e += 7) m.elements[e].covered = true, values[e] = glm::vec3(0);
    const auto corners = corner_values(m, values);
    for (std::size_t e = 0; e < m.elements.size(); ++e)
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(corners[e][i], glm::vec3(3));
    for (Element& e : m.elements) e.covered = true;
    for (const auto& element : corner_values(m, values)) EXPECT_EQ(element[0], glm::vec3(0));
}

} // namespace
} // namespace lightbench
