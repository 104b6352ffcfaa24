// Elements and patches: areas, edges that meet, aspects, sides, groups, sizes, what is covered.
#include "patches_support.h"
#include "scene/limits.h"

#include <ctime>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace lightbench {
namespace {

using namespace patches_test;
using make_test::made;
using tess::scene_of;
using tess::scene_of_mesh;

TEST(Patches, CutABoxIntoSquares) {
    const PatchMesh m = make_patches(scene_of({Box{{0, 0, 0}, {1, 2, 4}}}), {.element = 0.25, .patch = 1});
    expect_sound(m);
    EXPECT_EQ(m.elements.size(), 16u * 2 * (2 + 4 + 8));
    EXPECT_EQ(m.patches.size(), 2u * (2 + 4 + 8));
    EXPECT_EQ(m.points.size(), 16u * 2 * 14 + 2) << "Euler: V = E - F + 2, E = 2F";
    EXPECT_NEAR(area(m), 28, 28e-12);
    EXPECT_LE(worst_aspect(m), 1 + 1e-12);
    EXPECT_EQ(hanging_corners(m), 0u);
    EXPECT_EQ(open_edges(m), 0u);
    EXPECT_EQ(count_groups(m), 6u);
    for (const Element& e : m.elements) EXPECT_EQ(e.behind, kNoElement);
}

TEST(Patches, KeepTheAspectOfStripsAndPlates) {
    for (const glm::dvec3& size : {glm::dvec3(10, 0.05, 3), glm::dvec3(1, 1, 0.04), glm::dvec3(0.31, 0.7, 1.9)}) {
        const PatchMesh m = make_patches(scene_of({Box{{0, 0, 0}, size}}), {.element = 0.5});
        expect_sound(m);
        EXPECT_LE(worst_aspect(m), 2 + 1e-9) << size.x;
        EXPECT_EQ(open_edges(m), 0u);
        EXPECT_LE(longest_edge(m), 0.5 * (1 + 1e-12));
    }
    const PatchMesh thread = make_patches(scene_of({polygon({{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {0, 1e-9, 0}})}), {.element = 0.5});
    EXPECT_EQ(thread.elements.size(), 64u) << "32 a metre, two sides: not 500 million squares";
}

TEST(Patches, GoOnFromObjectToObjectOverSharedEdges) {
    const Scene scene = scene_of({polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
                                  polygon({{1, 0, 0}, {1, 0, 3}, {1, 1, 3}, {1, 1, 0}}), polygon({{0, 1, 0}, {1, 1, 0}, {0.5, 2, 0}})});
    for (const double element : {0.3, 0.5, 1.0, 4.0}) {
        const PatchMesh m = make_patches(scene, {.element = element});
        expect_sound(m);
        EXPECT_EQ(hanging_corners(m), 0u) << element;
        EXPECT_NEAR(area(m), 2 * 4.5, 1e-11);
        EXPECT_LE(longest_edge(m), element * (1 + 1e-12));
    }
}

TEST(Patches, MeetCornerToCornerWhereTrianglesAreCut) {
    // An L of six corners, a lone triangle upon its edge, a fan: cuts at halves keep all coordinates exact.
    const Scene scene = scene_of({polygon({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}}),
                                  polygon({{0, 0, 0}, {0, 4, 0}, {0, 2, 4}}), polygon({{4, 0, 0}, {4, 0, 8}, {4, 1, 0}})});
    for (const double element : {4.0, 1.0, 0.5, 0.3}) {
        const PatchMesh m = make_patches(scene, {.element = element, .patch = 2});
        expect_sound(m);
        EXPECT_EQ(hanging_corners(m), 0u) << element;
        EXPECT_NEAR(area(m), 2 * (7 + 8 + 4), 4e-11);
        EXPECT_LE(longest_edge(m), element * (1 + 1e-12));
        for (const Patch& p : m.patches) EXPECT_LE(p.radius / m.frame.scale, std::max(element, 2.0));
    }
}

TEST(Patches, HaveTwoSidesWhereTheRasteriserDrawsBoth) {
    Scene scene = scene_of({polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})});
    const PatchMesh both = make_patches(scene, {.element = 0.25});
    expect_sound(both);
    EXPECT_EQ(both.elements.size(), 32u);
    EXPECT_EQ(both.patches.size(), 2u);
    EXPECT_EQ(count_groups(both), 2u);
    EXPECT_EQ(both.elements[0].behind, 16u);
    scene.materials[0].two_sided = false;
    EXPECT_EQ(make_patches(scene, {.element = 0.25}).elements.size(), 16u);
}

TEST(Patches, GroupWhatIsSmooth) {
    EXPECT_EQ(count_groups(make_patches(scene_of({Sphere{}}), {})), 1u);
    EXPECT_EQ(count_groups(make_patches(scene_of({Cylinder{}}), {})), 3u);
    EXPECT_EQ(count_groups(make_patches(scene_of({Cone{}}), {})), 2u);
    EXPECT_EQ(count_groups(make_patches(scene_of({Torus{}}), {})), 1u);
    EXPECT_EQ(count_groups(make_patches(scene_of_mesh(tess::cube_mesh()), {})), 6u);
    EXPECT_EQ(count_groups(make_patches(scene_of_mesh(tess::cube_mesh(), 1.6f), {})), 1u) << "a crease angle of more than 90 degrees";
    const Mesh hill = tess::grid_mesh(8, [](float x, float y) { return 0.1f * x * y; });
    EXPECT_EQ(count_groups(make_patches(scene_of_mesh(hill), {})), 2u) << "its two sides";
}

TEST(Patches, CutCurvedShapesClosely) {
    const double pi = std::numbers::pi;
    const struct {
        Shape shape;
        double area;
    } cases[] = {{Sphere{{1, 2, 3}, 2}, 16 * pi},
                 {Cylinder{{0, 0, 0}, {0, 1, 0}, 0.5, true}, 1.5 * pi},
                 {Torus{{0, 0, 0}, {0, 1, 0}, 2, 0.5}, 4 * pi * pi}};
    for (const auto& c : cases) {
        const PatchMesh m = make_patches(scene_of({c.shape}), {});
        expect_sound(m);
        EXPECT_EQ(open_edges(m), 0u);
        EXPECT_NEAR(area(m) / c.area, 1, 0.005);
        EXPECT_GT(m.elements.size(), 4000u);
        EXPECT_LT(m.elements.size(), 16000u);
        EXPECT_LT(m.patches.size(), m.elements.size() / 5);
    }
    EXPECT_EQ(make_patches(scene_of({Sphere{}}), {.element = 100}).elements.size(), 20u);
}

TEST(Patches, OfTheCornellBoxAtAnySize) {
    const Scene scene = made("cornell-box");
    for (const std::size_t wanted : {1u, 100u, 1000u, 8000u, 40000u}) {
        const PatchMesh m = make_patches(scene, {.elements = wanted});
        expect_sound(m);
        EXPECT_LE(worst_aspect(m), wanted < 1000 ? 8 : 2.1) << wanted;
        for (const Element& e : m.elements) EXPECT_EQ(e.size(), 4u);
        if (wanted < 1000) continue;
        EXPECT_NEAR(double(m.elements.size()) / double(wanted), 1, 0.25);
        EXPECT_GE(m.elements.size(), 8 * m.patches.size());
        EXPECT_LE(m.elements.size(), 16 * m.patches.size());
        const auto lamp =
            std::count_if(m.elements.begin(), m.elements.end(), [&](const Element& e) { return m.surfaces[e.surface].material == 3; });
        EXPECT_GT(lamp, 0);
        for (const Element& e : m.elements)
            if (m.surfaces[e.surface].material == 3) {
                EXPECT_LT(e.normal.y, -0.999);
            }
    }
}

// The bottoms of the two blocks are not there.
TEST(Patches, AreCoveredUnderBlocks) {
    const auto area_of = [](std::vector<glm::dvec2> p) { // shoelace
        double twice = 0;
        for (std::size_t i = 0; i < 4; ++i) twice += p[i].x * p[(i + 1) % 4].y - p[i].y * p[(i + 1) % 4].x;
        return std::abs(twice) / 2;
    };
    const double blocks =
        area_of({{130, 65}, {82, 225}, {240, 272}, {290, 114}}) + area_of({{423, 247}, {265, 296}, {314, 456}, {472, 406}});
    const PatchMesh m = make_patches(made("cornell-box"), {.elements = 40000});
    double covered = 0;
    for (const Element& e : m.elements)
        if (e.covered) {
            covered += e.area;
            EXPECT_NEAR(e.normal.y, 1, 1e-12);
        }
    EXPECT_NEAR(covered / (m.frame.scale * m.frame.scale) / blocks, 1, 0.02);
}

TEST(Patches, AreCoveredUnderABoxAndAboveTheFloor) {
    const Polygon floor = polygon({{0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}});
    const auto covered = [](const PatchMesh& m) {
        return std::count_if(m.elements.begin(), m.elements.end(), [](const Element& e) { return e.covered; });
    };
    EXPECT_EQ(covered(make_patches(scene_of({floor, Box{{1, 0, 1}, {2, 1, 2}}}), {.element = 0.25})), 32)
        << "16 of the floor, 16 of the box";
    EXPECT_EQ(covered(make_patches(scene_of({floor, Box{{1, 0.001, 1}, {2, 1, 2}}}), {.element = 0.25})), 0);
    EXPECT_EQ(covered(make_patches(scene_of({floor, polygon({{1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}})}), {.element = 0.25})), 0)
        << "sheets back to back";
    const Scene lit = scene_of({floor, Box{{1, 0, 1}, {2, 1, 2}}}, glm::rotate(glm::translate(glm::dmat4(1), {7, 9, 1}), 0.3, {1, 2, 3.}));
    EXPECT_EQ(covered(make_patches(lit, {.element = 0.25})), 32) << "turned and moved";
}

TEST(Patches, OfNothingAndNextToNothing) {
    const PatchMesh none = make_patches(Scene{}, {});
    EXPECT_TRUE(none.elements.empty() && none.patches.empty() && none.points.empty());
    const PatchMesh one = make_patches(scene_of({polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}), {.element = 5});
    expect_sound(one);
    EXPECT_EQ(one.elements.size(), 2u);
    EXPECT_EQ(one.elements[0].corners[3], kNoCorner);
    const PatchMesh flat =
        make_patches(scene_of({polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})}), {});
    expect_sound(flat);
    EXPECT_EQ(flat.dropped, 1u);
}

TEST(Patches, AreTheSameEachTime) {
    const Scene scene = made("teapot");
    const PatchMesh a = make_patches(scene, {}), b = make_patches(scene, {});
    expect_sound(a);
    for (const Patch& patch : a.patches)
        EXPECT_LT(patch.radius, 0.6) << "its faces are more than was asked for: patches do not grow for that";
    ASSERT_EQ(a.elements.size(), b.elements.size());
    EXPECT_EQ(a.points, b.points);
    for (std::size_t i = 0; i < a.elements.size(); ++i) EXPECT_EQ(a.elements[i].corners, b.elements[i].corners);
}

TEST(Patches, MayBeElements) {
    PatchMesh mesh = make_patches(scene_of({Sphere{}, Box{}, polygon({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}})}), {.element = 0.5});
    ASSERT_LT(mesh.patches.size(), mesh.elements.size());
    make_elements_patches(mesh);
    ASSERT_EQ(mesh.patches.size(), mesh.elements.size());
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
        EXPECT_EQ(mesh.elements[i].patch, i);
        EXPECT_EQ(mesh.patches[i].area, mesh.elements[i].area);
        EXPECT_GT(mesh.patches[i].radius, 0);
    }
}

TEST(Patches, RefuseTooMany) {
    const Scene scene = scene_of({Sphere{}, Box{}, polygon({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}})});
    for (const double element : {1e-4, 1e-9, 1e-300}) EXPECT_THROW(make_patches(scene, {.element = element}), std::length_error) << element;
    EXPECT_THROW(make_patches(scene_of({Box{}}), {.element = 1e-4}), std::length_error);
    EXPECT_THROW(make_patches(scene_of({polygon({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}})}), {.element = 1e-4}), std::length_error);
}

TEST(Patches, TakeLittleTime) {
    const Scene scene = made("cornell-box");
    const std::clock_t start = std::clock(); // of this process alone
    EXPECT_GT(make_patches(scene, {.elements = 200000}).elements.size(), 180000u);
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 2);
}

} // namespace
} // namespace lightbench
