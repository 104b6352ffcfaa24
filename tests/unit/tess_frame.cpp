// Bounds, frame, and what must not change: scale by powers of two (SC-1), a far origin (SC-2), repetition.
#include "tess_support.h"

#include <glm/gtc/matrix_transform.hpp>

namespace lightbench {
namespace {

using namespace tess;

std::vector<Shape> one_of_each() {
    return {Sphere{{1, 2, 3}, 0.7},
            Polygon{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0.5, 0}, {0, 1, 0}}, {}},
            Box{{-1, -2, -1}, {0, -1, 0.5}},
            Cylinder{{3, 0, 0}, {3, 1, 1}, 0.4, true},
            Cone{{-3, 0, 0}, {-3, 2, 0.1}, 0.6, 0, true},
            Torus{{0, 3, 0}, {1, 1, 0}, 1, 0.3}};
}

glm::dmat4 crooked() {
    glm::dmat4 m = glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(0.3, -4, 2)), 0.7, glm::dvec3(1, 2, -1));
    m = glm::scale(m, glm::dvec3(1.5, 0.4, -2));
    m[1] += 0.3 * m[0];
    return m;
}

TEST(TessFrame, BoundsOfCurvedShapesAreTight) {
    for (const glm::dmat4& transform : {glm::dmat4(1), crooked()})
        for (const Shape& shape : one_of_each()) {
            const Scene scene = scene_of({shape}, transform);
            const Bounds bounds = bounds_of(scene);
            const auto g = tessellate(scene, {.eye = {0, 0, 30}, .pixel_angle = 2e-4});
            Bounds seen;
            for (const auto& t : triangles_of(g))
                for (const auto& p : t.p) seen.add(p + g.frame.origin);
            const glm::dvec3 size = bounds.max - bounds.min;
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(seen.min[i], bounds.min[i] - 1e-6 * size[i]);
                EXPECT_LE(seen.max[i], bounds.max[i] + 1e-6 * size[i]);
                EXPECT_NEAR(seen.min[i], bounds.min[i], 2e-3 * glm::length(size)) << shape.index();
                EXPECT_NEAR(seen.max[i], bounds.max[i], 2e-3 * glm::length(size)) << shape.index();
            }
        }
}

TEST(TessFrame, RadiusLiesBetweenOneAndTwo) {
    for (double size : {1e-9, 0.3, 1.0, 1.9999, 2.0, 777.0, 1e15}) {
        const Frame frame = frame_of({glm::dvec3(-size, 0, 0), glm::dvec3(size, 0, 0)});
        EXPECT_GE(frame.radius, 1);
        EXPECT_LT(frame.radius, 2);
        EXPECT_EQ(frame.radius, size * frame.scale);
        EXPECT_EQ(std::exp2(std::round(std::log2(frame.scale))), frame.scale);
    }
    EXPECT_EQ(frame_of({}).scale, 1);
    EXPECT_EQ(frame_of({glm::dvec3(5), glm::dvec3(5)}).scale, 1);
}

TEST(TessFrame, EmptySceneGivesNothing) {
    const auto g = tessellate(scene_of({}), {});
    EXPECT_TRUE(g.indices.empty());
    EXPECT_TRUE(g.clusters.empty());
}

TEST(TessFrame, ScaleByPowersOfTwoKeepsEveryBit) {
    const auto at_scale = [](int k) {
        const double s = std::ldexp(1.0, k);
        Scene scene = scene_of(one_of_each(), crooked());
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r) scene.transforms[1][c][r] *= s;
        scene.meshes.push_back(grid_mesh(6, [](float x, float y) { return 0.3f * x * y; }));
        scene.objects.push_back({.shape = MeshUse{0}, .transform = 1, .subdivide = 1});
        return tessellate(scene, {.eye = glm::dvec3(3, 4, 20) * s, .pixel_angle = 4e-3});
    };
    const auto reference = at_scale(0);
    expect_sound(reference);
    for (int k = -30; k <= 30; ++k) EXPECT_TRUE(same_bits(at_scale(k), reference)) << "2^" << k;
}

TEST(TessFrame, FarFromTheOriginNothingIsLost) {
    const glm::dvec3 far(1e5, -1e5, 3e5);
    const auto near_g = tessellate(scene_of(one_of_each()), {.eye = {0, 0, 20}});
    const auto far_g = tessellate(scene_of(one_of_each(), glm::translate(glm::dmat4(1), far)), {.eye = far + glm::dvec3(0, 0, 20)});
    ASSERT_EQ(near_g.vertices.positions.size(), far_g.vertices.positions.size());
    ASSERT_EQ(near_g.indices, far_g.indices);
    // 1e5 m in double has steps of 1.5e-11 m; a float32 step of the frame is 6e-8: the same number, or its neighbour.
    for (std::size_t i = 0; i < near_g.vertices.positions.size(); ++i) {
        const glm::vec3 d = near_g.vertices.positions[i].position - far_g.vertices.positions[i].position;
        EXPECT_LE(glm::length(d), 2.5e-7f);
    }
}

TEST(TessFrame, RepetitionGivesTheSameBits) {
    Scene scene = scene_of(one_of_each());
    scene.meshes.push_back(grid_mesh(150, [](float x, float y) { return 0.1f * std::sin(20 * x) * y; }));
    scene.objects.push_back({.shape = MeshUse{0}});
    const TessellationRequest request{.eye = {0, 0, 30}};
    const auto first = tessellate(scene, request);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(same_bits(tessellate(scene, request), first));
}

} // namespace
} // namespace lightbench
