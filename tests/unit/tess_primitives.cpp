// Curved primitives: closeness to the true surface, closed meshes, outward normals, volumes, the cost of small ones.
#include "scene/tessellate_job.h"
#include "tess_support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace lightbench {
namespace {

using namespace tess;

const double kPi = std::numbers::pi;

// Distance of a point from the surfaces under test, written from their definitions; the caps' planes do not count.
double off_sphere(const glm::dvec3& p) {
    return std::abs(glm::length(p) - 2);
}
double off_cylinder(const glm::dvec3& p) {
    return std::abs(std::hypot(p.x, p.z) - 0.5);
}
double off_torus(const glm::dvec3& p) {
    return std::abs(std::hypot(std::hypot(p.x, p.z) - 2, p.y) - 0.5);
}
double off_cone(const glm::dvec3& p) { // radius 1 at y = -1, 0 at y = 1
    return std::abs(std::hypot(p.x, p.z) - 0.5 * (1 - p.y)) / std::sqrt(1.25);
}

double worst_error(const RasterGeometry& g, double (*off)(const glm::dvec3&), bool skip_caps) {
    double worst = 0;
    for (const auto& t : triangles_of(g)) {
        if (skip_caps && std::abs(glm::normalize(t.cross()).y) > 0.99) continue;
        for (int i = 0; i <= 12; ++i)
            for (int j = 0; i + j <= 12; ++j)
                worst = std::max(worst, off((t.p[0] * double(i) + t.p[1] * double(j) + t.p[2] * double(12 - i - j)) / 12.0));
    }
    return worst;
}

TEST(TessPrimitives, ChordErrorIsKept) {
    struct Case {
        Shape shape;
        double (*off)(const glm::dvec3&);
        bool caps;
        double radius;
    };
    const Case cases[] = {{Sphere{{0, 0, 0}, 2}, off_sphere, false, 2},
                          {Cylinder{{0, -1, 0}, {0, 1, 0}, 0.5, true}, off_cylinder, true, std::sqrt(1.25)},
                          {Cone{{0, -1, 0}, {0, 1, 0}, 1, 0, true}, off_cone, true, std::sqrt(2.0)},
                          {Torus{{0, 0, 0}, {0, 1, 0}, 2, 0.5}, off_torus, false, 2.5}};
    for (const Case& c : cases)
        for (double pixel : {3e-1, 3e-2, 1e-2, 1e-3}) {
            const TessellationRequest request{.eye = {0, 3, 9}, .pixel_angle = pixel};
            const double allowed = 0.25 * pixel * (std::sqrt(90.0) - c.radius);
            const auto g = tessellate(scene_of({c.shape}), request);
            const double worst = worst_error(g, c.off, c.caps);
            EXPECT_LE(worst, allowed * (1 + 1e-9) + 3e-7) << c.shape.index() << " " << pixel;
            if (pixel < 2e-2) {
                EXPECT_GE(worst, allowed / 4) << "finer than was asked: " << c.shape.index() << " " << pixel;
            }
        }
}

TEST(TessPrimitives, ChordErrorIsKeptUnderUnevenScale) {
    const glm::dmat4 stretched = glm::scale(glm::dmat4(1), glm::dvec3(1, 10, 1));
    const auto g = tessellate(scene_of({Sphere{{0, 0, 0}, 2}}, stretched), {.eye = {0, 0, 100}, .pixel_angle = 1e-3});
    double worst = 0;
    for (const auto& t : triangles_of(g)) {
        glm::dvec3 m = (t.p[0] + t.p[1] + t.p[2]) / 3.0;
        worst = std::max(worst, glm::length(m) * (2 / glm::length(m / glm::dvec3(1, 10, 1)) - 1));
    }
    EXPECT_LE(worst, 0.25e-3 * 80);
}

TEST(TessPrimitives, ClosedShapesAreWatertight) {
    struct Case {
        Shape shape;
        long euler;
        double volume;
    };
    const Case cases[] = {{Sphere{{1, 1, 1}, 1}, 2, 4 * kPi / 3},
                          {Box{{0, 0, 0}, {1, 2, 3}}, 2, 6},
                          {Cylinder{{1, 0, 0}, {1, 2, 2}, 0.5, true}, 2, kPi / 4 * std::sqrt(8.0)},
                          {Cone{{1, 0, 0}, {1, 3, 0}, 1, 0, true}, 2, kPi},
                          {Cone{{1, 0, 0}, {1, 3, 0}, 0, 1, true}, 2, kPi},
                          {Cone{{1, 0, 0}, {1, 3, 0}, 1, 0.5, true}, 2, kPi * (1 + 0.5 + 0.25)},
                          {Torus{{0, 0, 0}, {1, 2, 3}, 1, 0.25}, 0, 2 * kPi * kPi / 16}};
    glm::dmat4 crooked = glm::scale(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(1, 2, 3)), glm::dvec3(1, 2, -0.5));
    for (const glm::dmat4& transform : {glm::dmat4(1), glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)), crooked})
        for (const Case& c : cases)
            for (unsigned subdivide : {0u, 2u})
                for (bool normals : {true, false}) {
                    const auto g = tessellate(scene_of({c.shape}, transform),
                                              {.eye = {0, 0, 20}, .pixel_angle = 5e-3, .subdivide = subdivide, .normals = normals});
                    expect_sound(g, normals);
                    if (c.shape.index() != 0) expect_provoked_in_plane(g);
                    const Topology topology = topology_of(g);
                    EXPECT_TRUE(topology.closed) << c.shape.index() << ": " << topology.open_edges << " open edges";
                    EXPECT_EQ(topology.euler, c.euler) << c.shape.index();
                    const double volume = c.volume * std::abs(glm::determinant(glm::dmat3(transform)));
                    EXPECT_NEAR(volume_of(g), volume, (subdivide ? 5e-3 : 8e-2) * volume) << c.shape.index();
                    EXPECT_EQ(g.one_sided_clusters, g.clusters.size()) << c.shape.index();
                }
}

TEST(TessPrimitives, OpenShapesAreTwoSidedAndOpen) {
    for (const Shape& shape : {Shape(Cylinder{{0, 0, 0}, {0, 1, 0}, 0.5, false}), Shape(Cone{{0, 0, 0}, {0, 1, 0}, 1, 0, false})}) {
        const auto g = tessellate(scene_of({shape}), {});
        expect_sound(g);
        EXPECT_FALSE(topology_of(g).closed);
        EXPECT_EQ(g.one_sided_clusters, 0u);
        EXPECT_EQ(g.faces_two_sided, g.polygons.positions.size());
    }
}

TEST(TessPrimitives, NormalsAreTheTrueOnes) {
    const TessellationRequest request{.eye = {0, 0, 30}};
    for (const auto& t : triangles_of(tessellate(scene_of({Sphere{{0, 0, 0}, 2}}), request)))
        for (int k = 0; k < 3; ++k) EXPECT_LE(glm::distance(t.n[k], t.p[k] / 2.0), 2e-7);
    for (const auto& t : triangles_of(tessellate(scene_of({Torus{{0, 0, 0}, {0, 1, 0}, 2, 0.5}}), request)))
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 middle = 2.0 * glm::normalize(glm::dvec3(t.p[k].x, 0, t.p[k].z));
            EXPECT_LE(glm::distance(t.n[k], (t.p[k] - middle) / 0.5), 2e-6);
        }
    for (const auto& t : triangles_of(tessellate(scene_of({Cone{{0, -1, 0}, {0, 1, 0}, 1, 0, true}}), request))) {
        const glm::dvec3 face = glm::normalize(t.cross());
        for (int k = 0; k < 3; ++k) {
            if (face.y < -0.99) {
                EXPECT_EQ(t.n[k], glm::dvec3(0, -1, 0));
            } else if (t.p[k].y < 0.99) {
                const glm::dvec3 outward = glm::normalize(glm::dvec3(t.p[k].x, 0, t.p[k].z));
                EXPECT_LE(glm::distance(t.n[k], glm::normalize(glm::dvec3(2 * outward.x, 1, 2 * outward.z))), 1e-6);
            } else {
                EXPECT_GE(glm::dot(t.n[k], face), 0.99999) << "the tip's normal is that of its piece";
            }
        }
    }
}

// The gradient of the ellipsoid x^T M^-T M^-1 x = 1, in long double.
TEST(TessPrimitives, NormalsOfAnUnevenMirroredSphereAreTheGradient) {
    glm::dmat4 m = glm::scale(glm::rotate(glm::dmat4(1), 1.1, glm::dvec3(3, 2, 1)), glm::dvec3(1, -0.5, 0.7));
    m[2] += 0.4 * m[0];
    const auto inverse = glm::inverse(glm::tmat3x3<long double>(glm::dmat3(m)));
    for (const auto& t : triangles_of(tessellate(scene_of({Sphere{{0, 0, 0}, 1}}, m), {.eye = {0, 0, 10}})))
        for (int k = 0; k < 3; ++k) {
            const auto gradient = glm::transpose(inverse) * (inverse * glm::tvec3<long double>(t.p[k]));
            EXPECT_LE(glm::distance(t.n[k], glm::dvec3(glm::normalize(gradient))), 2e-6);
        }
}

TEST(TessPrimitives, SmallOnesCostLittle) {
    const TessellationRequest far{.eye = {0, 0, 2000}}; // a pixel is 2 m
    EXPECT_LE(tessellate(scene_of({Sphere{}}), far).indices.size(), 3 * 8u);
    EXPECT_LE(tessellate(scene_of({Cylinder{}}), far).indices.size(), 3 * 24u);
    EXPECT_LE(tessellate(scene_of({Cone{}}), far).indices.size(), 3 * 12u);
    EXPECT_LE(tessellate(scene_of({Torus{}}), far).indices.size(), 3 * 72u);
}

TEST(TessPrimitives, AnEyeInsideDoesNotExhaustTheMachine) {
    for (const Shape& shape : {Shape(Sphere{}), Shape(Cylinder{}), Shape(Torus{})}) {
        const Scene scene = scene_of({shape});
        EXPECT_LE(triangle_count(job_of(scene, {.eye = {0, 0, 0}, .pixel_angle = 1e-9}, {}, 0)), 600'000u);
    }
}

TEST(TessPrimitives, CountsAreThoseOfTheTrianglesMade) {
    for (const Shape& shape :
         {Shape(Sphere{}), Shape(Cylinder{}), Shape(Torus{}), Shape(Cone{}), Shape(Cone{{0, 0, 0}, {0, 1, 0}, 1, 2, false}), Shape(Box{})})
        for (unsigned subdivide : {0u, 1u, 2u}) {
            const Scene scene = scene_of({shape});
            const TessellationRequest request{.eye = {0, 0, 20}, .pixel_angle = 0.01, .subdivide = subdivide};
            EXPECT_EQ(triangle_count(job_of(scene, request, frame_of(bounds_of(scene)), 0)), tessellate(scene, request).indices.size() / 3);
        }
}

TEST(TessPrimitives, SubdivisionHalvesEveryPiece) {
    for (const Shape& shape : {Shape(Sphere{}), Shape(Torus{}), Shape(Box{}), Shape(Cylinder{})}) {
        const auto rough = tessellate(scene_of({shape}), {.eye = {0, 0, 50}}),
                   fine = tessellate(scene_of({shape}), {.eye = {0, 0, 50}, .subdivide = 1});
        std::set<Key> points;
        for (const auto& t : triangles_of(fine))
            for (const auto& p : t.p) points.insert(key_of(p));
        for (const auto& t : triangles_of(rough))
            for (const auto& p : t.p) EXPECT_TRUE(points.contains(key_of(p))) << shape.index();
        if (shape.index() != 3) {
            EXPECT_EQ(fine.indices.size(), 4 * rough.indices.size());
        }
    }
}

TEST(TessPrimitives, FlatOnesHaveNoNormalsThatVanish) {
    for (double flat : {1e-1, 1e-3, 1e-6}) {
        const auto g =
            tessellate(scene_of({Sphere{}, Torus{}, Cylinder{}}, glm::scale(glm::dmat4(1), glm::dvec3(1, flat, 1))), {.eye = {0, 0, 30}});
        expect_sound(g);
        for (const auto& t : triangles_of(g))
            for (int i = 0; i <= 8; ++i)
                for (int j = 0; i + j <= 8; ++j)
                    EXPECT_GE(glm::length(t.n[0] * double(i) + t.n[1] * double(j) + t.n[2] * double(8 - i - j)) / 8, 0.0499);
    }
}

TEST(TessPrimitives, MaterialDecidesSides) {
    Scene scene = scene_of({Sphere{}});
    scene.materials[0].two_sided = true;
    EXPECT_EQ(tessellate(scene, {.eye = {0, 0, 9}}).one_sided_clusters, 0u);
    scene = scene_of({Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}}});
    EXPECT_EQ(tessellate(scene, {}).one_sided_clusters, 0u);
    scene.materials[0].two_sided = false;
    EXPECT_EQ(tessellate(scene, {}).one_sided_clusters, 1u);
}

} // namespace
} // namespace lightbench
