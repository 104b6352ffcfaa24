// Every structure finds the same hits: pictures agree to the last bit (TS-1), also where a walk takes more rounds than a driver allows in one
// dispatch and is put down and taken up again (TS-10).
#include "images/ray_reference.h"
#include "scene/make.h"

#include <gtest/gtest.h>

#include <random>

namespace lightbench::testing {
namespace {

constexpr Structure kStructures[] = {Structure::none, Structure::bvh, Structure::sphere_bvh, Structure::grid, Structure::octree};

std::vector<float> traced(const Scene& scene, Structure structure, glm::uvec2 size, bool count = false,
                          const AccelParameters& parameters = {}) {
    Request request = ray_request(size, 4);
    request.accel = structure, request.count = count, request.accel_parameters = parameters;
    return render_scene(scene, request).output.radiance.value().rgba;
}

void expect_equal_pictures(const Scene& scene, glm::uvec2 size = {48, 36}) {
    const auto reference = traced(scene, Structure::none, size);
    EXPECT_GT(*std::ranges::max_element(reference), 0.0f);
    for (const Structure structure : kStructures)
        EXPECT_EQ(traced(scene, structure, size), reference) << "structure " << static_cast<int>(structure);
    EXPECT_EQ(traced(scene, Structure::bvh, size, true), reference) << "counting, which leaves packets out";
    EXPECT_EQ(traced(scene, Structure::bvh, size, false, {TreeBuilder::device}), reference) << "built on the device";
    EXPECT_EQ(traced(scene, Structure::bvh, size, true, {TreeBuilder::device, 1}), reference) << "likewise, counting, one to a leaf";
}

Scene made(std::string_view kind, const MakeArguments& arguments) {
    return std::get<Scene>(make_scene(kind, arguments));
}

// Spheres of like size about each other's middles: boxes overlap everywhere, and each ray meets many.
Scene crowd(unsigned spheres) {
    Scene scene = plane_scene({0, 3, 9});
    scene.lights = {point_light({3, 9, 6}, glm::vec3(1))};
    std::mt19937 random(7);
    const auto coordinate = [&] { return double(random()) * 0x1p-31 - 1; };
    for (unsigned i = 0; i < spheres; ++i) {
        Object object;
        object.shape = Sphere{{coordinate(), coordinate() + 1, coordinate()}, 0.75 + 0.25 * coordinate()};
        scene.objects.push_back(object);
    }
    scene.materials[0].reflection = glm::vec3(0.3f);
    return scene;
}

TEST(RayStructures, ShapesOfAllKinds) {
    expect_equal_pictures(made("primitives", {}));
}

TEST(RayStructures, ManySmallSpheres) {
    expect_equal_pictures(made("sphereflake", {{"depth", "3"}}));
}

TEST(RayStructures, MirrorsFacingEachOther) {
    expect_equal_pictures(made("mirrors", {}));
}

TEST(RayStructures, CoincidentSurfacesAndGlass) {
    Scene scene = crowd(20);
    scene.objects.push_back(scene.objects[1]), scene.objects.push_back(scene.objects[2]);
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].opacity = glm::vec3(0.4f), scene.materials[1].transmission = glm::vec3(0.5f);
    for (std::size_t i = 1; i < scene.objects.size(); i += 2) scene.objects[i].material = 1;
    expect_equal_pictures(scene);
}

// Glass on a floor that mirrors, faces and all: what touches is ordered by more than distance.
TEST(RayStructures, GlassThatTouches) {
    Scene scene = plane_scene({2, 2, 5});
    scene.lights = {point_light({3, 9, 6}, glm::vec3(1))};
    scene.materials[0].reflection = glm::vec3(0.3f);
    scene.materials.resize(3, scene.materials[0]);
    scene.materials[1].transmission = glm::vec3(0.8f, 0.6f, 0.4f), scene.materials[1].fresnel = true;
    scene.materials[2].opacity = glm::vec3(0.5f);
    for (const Shape& shape : {Shape(Box{{-1, 0, -1}, {0.3, 0.7, 1}}), Shape(Sphere{{0.9, 0.5, 0.5}, 0.5})})
        scene.objects.push_back({.shape = shape, .material = 1});
    scene.objects.push_back({.shape = Polygon{{{0.3, 0, 1}, {0.3, 0.5, 1}, {0.3, 0.5, -1}, {0.3, 0, -1}}, {}}, .material = 2});
    expect_equal_pictures(scene);
}

// 12 000 spheres, all of them tested against each ray: more rounds than one dispatch takes.
TEST(RayStructures, WalksLongerThanADispatch) {
    const Scene scene = crowd(12000);
    const auto reference = traced(scene, Structure::bvh, {8, 6});
    EXPECT_EQ(traced(scene, Structure::none, {8, 6}), reference);
    EXPECT_EQ(traced(scene, Structure::bvh, {8, 6}, false, {TreeBuilder::device}), reference);
}

TEST(RayStructures, TreesOfTwoOneAndNothing) {
    for (const unsigned spheres : {2u, 1u, 0u}) {
        Scene scene = crowd(spheres);
        scene.objects.erase(scene.objects.begin());
        EXPECT_EQ(traced(scene, Structure::bvh, {48, 36}, false, {TreeBuilder::device}), traced(scene, Structure::none, {48, 36}))
            << spheres;
    }
}

} // namespace
} // namespace lightbench::testing
