// Procedural scenes of materials, detail and transparency.
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
