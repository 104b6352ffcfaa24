// Objects as rays see them: the facets that the rasteriser cuts of a shape must lie on the canonical shape, within its boxes and spheres.
#include "accel_support.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

namespace lightbench::accel_tests {
namespace {

Scene scene_of(std::vector<Shape> shapes, const glm::dmat4& transform = glm::dmat4(1)) {
    Scene scene;
    scene.materials.resize(1);
    scene.transforms.push_back(transform);
    for (auto& shape : shapes) scene.objects.push_back({.shape = std::move(shape), .transform = 1});
    return scene;
}

RayPrimitives analytic(const Scene& scene) {
    return ray_primitives(scene, tessellate(scene, {.analytic = true}));
}

std::vector<glm::dvec3> facet_points(const Scene& scene) {
    std::vector<glm::dvec3> points;
    for (const auto& p : tessellate(scene, {.eye = frame_of(bounds_of(scene)).origin, .pixel_angle = 4e-3}).vertices.positions)
        points.emplace_back(p.position);
    return points;
}

// 0 on the canonical surface; about the distance from it, in units of the shape.
double distance(const RayShape& s, const glm::dvec3& q) {
    const double across = std::hypot(q.x, q.y), m = 0.5 * (s.p0 + s.p1), k = 0.5 * (double{s.p1} - double{s.p0});
    switch (s.kind) {
    case kShapeBox: return std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}) - 1;
    case kShapeBall: return glm::length(q) - 1;
    case kShapeTorus: return std::hypot(across - 1, q.z) - double{s.p0};
    default: return std::max(across - (m + k * q.z), std::abs(q.z) - 1);
    }
}

struct Case {
    Shape shape;
    uint kind;
};

std::vector<Case> cases() {
    return {{Box{{-0.3, 0.1, -0.7}, {0.6, 0.4, 1.2}}, kShapeBox},
            {Sphere{{0.2, 0.1, -0.4}, 0.7}, kShapeBall},
            {Cylinder{{0.1, -0.5, 0}, {0.9, 0.7, 0.3}, 0.4}, kShapeCone},
            {Cone{{0.1, -0.5, 0}, {-0.9, 0.7, 0.3}, 0.4, 0.1, false}, kShapeCone},
            {Cone{{0, 0, 1}, {0, 0, 3}, 0, 2}, kShapeCone},
            {Torus{{0.5, 0, 0.1}, {1, 2, -1}, 0.8, 0.3}, kShapeTorus}};
}

std::vector<glm::dmat4> transforms() {
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 3)),
                     far = glm::translate(glm::dmat4(1), glm::dvec3(1e5, -3e5, 2e5));
    glm::dmat4 shear(1);
    shear[1][0] = 0.8, shear[2][1] = -0.4;
    return {glm::scale(turned, glm::dvec3(1, 2, 0.5)), far * turned * shear, glm::scale(glm::dmat4(1), glm::dvec3(-1e-4, 1e-4, 3e-4)),
            glm::scale(turned * shear, glm::dvec3(1e4, 1e2, 1))};
}

TEST(AccelPrimitives, FacetsLieOnTheShape) {
    for (const auto& [shape, kind] : cases())
        for (const glm::dmat4& transform : transforms()) {
            const Scene scene = scene_of({shape}, transform);
            RayPrimitives p = analytic(scene);
            ASSERT_EQ(p.shapes.size(), 1u);
            const RayShape& s = p.shapes[0];
            EXPECT_EQ(s.kind, kind);
            const FloatBox box = boxes_of(p)[0];
            const glm::vec4 sphere = spheres_of(p)[0];
            const glm::dmat3 linear = glm::transpose(glm::dmat3(s.row_x, s.row_y, s.row_z)),
                             back = glm::transpose(glm::dmat3(s.back_x, s.back_y, s.back_z));
            const glm::dvec3 center(s.center_x, s.center_y, s.center_z);
            glm::dvec3 least(1e9), most(-1e9);
            for (const glm::dvec3& point : facet_points(scene)) {
                // Points and matrices are rounded to 2^-24 of their size; |linear| |point| is what that is multiplied by.
                const glm::dvec3 amplified =
                    glm::dmat3(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2])) * (glm::abs(point) + glm::abs(center));
                const double bound = 0x1p-21 * (1 + std::max({amplified.x, amplified.y, amplified.z}));
                const glm::dvec3 q = linear * (point - center);
                EXPECT_NEAR(distance(s, q), 0, bound) << "kind " << s.kind;
                const glm::dvec3 there = glm::dmat3(glm::abs(back[0]), glm::abs(back[1]), glm::abs(back[2])) * amplified;
                EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(back * q + center - point), 0x1p-22 * there + 0x1p-24)));
                EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::dvec3(box.min), point)) &&
                            glm::all(glm::lessThanEqual(point, glm::dvec3(box.max))));
                EXPECT_LE(glm::length(point - glm::dvec3(sphere)), double{sphere.w});
                least = glm::min(least, point), most = glm::max(most, point);
            }
            // Facets are chords: their box is smaller by a part of the size. What else the shape's box has is padding, on six sides.
            const glm::dvec3 sums = glm::abs(linear[0]) + glm::abs(linear[1]) + glm::abs(linear[2]);
            const glm::dvec3 padding = error_of_rays(p) * (glm::dmat3(glm::abs(back[0]), glm::abs(back[1]), glm::abs(back[2])) * sums);
            EXPECT_LE(glm::length(glm::dvec3(box.max) - most) + glm::length(glm::dvec3(box.min) - least),
                      0.05 + 2.1 * glm::length(padding));
        }
}

TEST(AccelPrimitives, SpheresUnderSimilaritiesStaySpheres) {
    const glm::dmat4 transform = glm::scale(glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 3)), glm::dvec3(-3, 3, 3));
    const Scene scene = scene_of({Sphere{{1, 0, 0}, 0.5}, Sphere{{-1, 0, 0}, 0.25}}, transform);
    const RayPrimitives p = analytic(scene);
    ASSERT_EQ(p.spheres.size(), 2u);
    EXPECT_TRUE(p.shapes.empty());
    EXPECT_FLOAT_EQ(p.spheres[0].radius, 2 * p.spheres[1].radius);
    EXPECT_NEAR(double{p.spheres[0].radius} / p.frame.scale, 1.5, 1e-6);
}

TEST(AccelPrimitives, FlatShapesAreDroppedAndCounted) {
    const glm::dmat4 flat = glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1));
    const RayPrimitives p =
        analytic(scene_of({Box{}, Sphere{}, Cylinder{}, Torus{}, Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {}}}, flat));
    EXPECT_EQ(p.dropped, 4u);
    EXPECT_EQ(p.size(), 1u);
    EXPECT_EQ(analytic(scene_of({Cone{{0, 0, 0}, {0, 0, 0}, 1, 1}, Sphere{}})).dropped, 1u);
}

Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    mesh.face_starts = {0, 3, 6, 9, 12};
    mesh.face_materials = {0, 1, 1, 0};
    return mesh;
}

TEST(AccelPrimitives, NumbersAndNames) {
    Scene scene = scene_of({Sphere{}, MeshUse{0}, Box{}, Polygon{{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}, {}}, MeshUse{0}});
    scene.materials.resize(3);
    scene.meshes.push_back(tetrahedron());
    scene.objects[2].material = 2;
    for (bool normals : {true, false}) {
        const RasterGeometry g = tessellate(scene, {.normals = normals, .analytic = true});
        const RayPrimitives p = ray_primitives(scene, g);
        ASSERT_EQ(p.triangles.size(), 4u + 2 + 4);
        ASSERT_EQ(p.corners.size(), p.triangles.size());
        ASSERT_EQ(g.object_surfaces.size(), scene.objects.size());
        const std::array<std::uint32_t, 10> objects{1, 1, 1, 1, 3, 3, 4, 4, 4, 4}, materials{0, 1, 1, 0, 0, 0, 0, 1, 1, 0};
        for (std::size_t i = 0; i < p.triangles.size(); ++i) {
            const RayTriangle& t = p.triangles[i];
            EXPECT_EQ(t.number, i);
            EXPECT_EQ(t.object, objects[i]);
            EXPECT_EQ(g.surfaces.at(t.surface).material, materials[i]);
            EXPECT_EQ(t.v0, g.vertices.positions.at(p.corners[i].a).position);
            EXPECT_EQ(t.v1, g.vertices.positions.at(p.corners[i].b).position);
            EXPECT_EQ(t.v2, g.vertices.positions.at(p.corners[i].c).position);
            EXPECT_EQ(g.polygon_objects.at(p.corners[i].polygon), objects[i]);
        }
        ASSERT_EQ(p.spheres.size(), 1u);
        ASSERT_EQ(p.shapes.size(), 1u);
        EXPECT_EQ(p.spheres[0].number, 10u);
        EXPECT_EQ(p.shapes[0].number, 11u);
        EXPECT_EQ(p.shapes[0].object, 2u);
        EXPECT_EQ(g.surfaces.at(p.shapes[0].surface).material, 2u);
    }
}

// SC-1: a scene scaled by 2^k is the same primitives.
TEST(AccelPrimitives, ScalesBitForBit) {
    const auto scaled = [](int k) {
        std::vector<Shape> shapes;
        for (const auto& c : cases()) shapes.push_back(c.shape);
        const double s = std::ldexp(1.0, k);
        return analytic(scene_of(shapes, glm::scale(glm::dmat4(1), glm::dvec3(s)) * transforms()[0]));
    };
    const RayPrimitives one = scaled(0);
    for (int k : {-30, 30}) {
        const RayPrimitives other = scaled(k);
        ASSERT_EQ(one.shapes.size(), other.shapes.size());
        EXPECT_EQ(std::memcmp(one.shapes.data(), other.shapes.data(), one.shapes.size() * sizeof(RayShape)), 0);
    }
}

} // namespace
} // namespace lightbench::accel_tests
