// One scene by rasteriser and ray tracer (CA-4), scaled and moved scenes (SC-1, SC-2), shapes that must not shadow themselves (SP-4, SH-1).
#include "images/ray_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace lightbench::testing {
namespace {

using glm::dvec3;

// A ball, a ring, a can, a turned box, a floor; lights of all kinds and laws.
Scene mixed_scene() {
    Scene scene = plane_scene({3, 4, 6});
    scene.environment.ambient = glm::vec3(0.05f), scene.environment.background = {0.1f, 0.2f, 0.4f};
    Material shiny;
    shiny.diffuse = {0.2f, 0.4f, 0.8f}, shiny.specular = glm::vec3(0.5f), shiny.shininess = 40;
    scene.materials.push_back(shiny);
    Object ball, ring, can, box;
    ball.shape = Sphere{{0, 1, 0}, 1}, ball.material = 1;
    ring.shape = Torus{{2, 0.5, 1}, {0, 1, 0}, 1, 0.25};
    can.shape = Cylinder{{-2, 0.2, 1}, {-2.4, 1.2, 1.5}, 0.4}, can.material = 1;
    box.shape = Box{{-1, 0.125, 2}, {0, 0.5, 3}};
    scene.objects.insert(scene.objects.end(), {ball, ring, can, box});
    scene.lights = lights_of_every_kind();
    return scene;
}

// Everything that can be sent on, so that every kind of ray is scaled.
Scene glassy_scene() {
    Scene scene = mixed_scene();
    scene.materials[0].opacity = glm::vec3(0.75f);
    scene.materials[1].transmission = glm::vec3(0.5f), scene.materials[1].fresnel = true, scene.materials[1].diffuse *= 0.25f;
    return scene;
}

TEST(RayAgree, ScaleByAPowerOfTwoChangesNoBit) {
    const auto want = render_scene(glassy_scene(), ray_request()).output.radiance->rgba;
    for (const int k : {-30, -7, 1, 30}) {
        Scene scene = glassy_scene();
        scale_scene(scene, std::ldexp(1.0, k));
        EXPECT_EQ(render_scene(scene, ray_request()).output.radiance->rgba, want) << "k = " << k;
    }
}

TEST(RayAgree, TranslationByAHundredKilometresHardlyMatters) {
    const ImageF want = *render_scene(glassy_scene(), ray_request({96, 72})).output.radiance;
    Scene scene = glassy_scene();
    const dvec3 far(1e5, -1e5, 1e5);
    scene.transforms.push_back(glm::dmat4(1));
    scene.transforms.back()[3] = glm::dvec4(far, 1);
    for (Object& o : scene.objects) o.transform = 1;
    for (Camera& c : scene.cameras) c.position += far, c.target += far;
    for (Light& l : scene.lights) l.position += far;
    const ImageF got = *render_scene(scene, ray_request({96, 72})).output.radiance;
    unsigned differ = 0;
    for (std::size_t i = 0; i < got.rgba.size(); i += 4) differ += std::abs(got.rgba[i] - want.rgba[i]) > 1.0f / 255;
    EXPECT_LE(differ, got.rgba.size() / 4 / 1000);
}

struct Difference {
    double share = 0, worst = 0;
    glm::uvec2 where{0};
};

// Of pixels that are not within one pixel of an edge of the traced picture (a step of more than `edge` to a neighbour).
Difference difference(const ImageF& drawn, const ImageF& traced, double tolerance, double edge) {
    Difference out;
    unsigned inner = 0, off = 0;
    const auto far = [](const dvec3& a, const dvec3& b) { return glm::length(a - b); };
    for (unsigned y = 1; y + 1 < traced.height; ++y)
        for (unsigned x = 1; x + 1 < traced.width; ++x) {
            const dvec3 want = pixel(traced, x, y);
            double step = 0;
            for (int i = 0; i < 9; ++i) step = std::max(step, far(want, pixel(traced, x + unsigned(i % 3) - 1, y + unsigned(i / 3) - 1)));
            if (step > edge) continue;
            ++inner;
            const double d = far(want, pixel(drawn, x, y));
            off += d > tolerance;
            if (d > out.worst) out.worst = d, out.where = {x, y};
        }
    EXPECT_GT(inner, traced.width * traced.height / 3);
    out.share = double(off) / (double(traced.width) * traced.height);
    return out;
}

void expect_alike(const Scene& scene, const std::string& what, double tolerance = 1.2e-2, double edge = 0.05) {
    Request traced = ray_request({160, 120}, 1), drawn = radiance_request(Shading::phong, {160, 120});
    const ImageF a = *render_scene(scene, drawn).output.radiance, b = *render_scene(scene, traced).output.radiance;
    const Difference d = difference(a, b, tolerance, edge);
    EXPECT_LE(d.share, 1e-3) << what << ": worst " << d.worst << " at " << d.where.x << ' ' << d.where.y;
}

// The rasteriser has no shadows: a headlight has none either, seen from where it is.
Scene headlit(Scene scene) {
    scene.lights = {point_light(scene.cameras[0].position, glm::vec3(6), Attenuation::linear)};
    return scene;
}

TEST(RayAgree, DrawnAndTracedPicturesAreAlike) {
    expect_alike(headlit(mixed_scene()), "phong");
}

TEST(RayAgree, DrawnAndTracedTexturesAndBumpsAreAlike) {
    for (const Mapping mapping : {Mapping::spherical, Mapping::planar}) {
        Scene scene = headlit(mixed_scene());
        // 2.3: no whole face of the scene lies along an edge of the checker.
        for (Material& m : scene.materials) m.texture = Texture{{}, mapping, {3, 2.3}};
        expect_alike(scene, fmt::format("checker, mapping {}", int(mapping)), 1.2e-2, 0.03);
    }
    for (const BumpFunction function : {BumpFunction::waves}) {
        Scene scene = headlit(mixed_scene());
        for (Material& m : scene.materials) m.bump = Bump{{}, false, function, 0.02, 2};
        expect_alike(scene, function == BumpFunction::waves ? "waves" : "noise", 2e-2, 0.1);
    }
}

Object glowing(Scene& scene, const Shape& shape, const glm::vec3& color, std::optional<bool> two_sided) {
    Material m;
    m.diffuse = glm::vec3(0), m.emission = color, m.two_sided = two_sided;
    scene.materials.push_back(m);
    Object object;
    object.shape = shape, object.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    return object;
}

// What is said to be one-sided is not seen from behind, whichever way it is drawn: a front, two backs, and a ball around the eye.
TEST(RayAgree, BacksOfOneSidedSurfacesAreNotSeen) {
    const auto square = [](double x, double z, double size, double turn) {
        return Polygon{{{x - turn * size, -size, z}, {x + turn * size, -size, z}, {x + turn * size, size, z}, {x - turn * size, size, z}},
                       {}};
    };
    Scene scene = plane_scene({0, 0, 6});
    scene.cameras[0].up = {0, 1, 0};
    scene.objects = {glowing(scene, square(0, -2, 9, 1), {1, 0, 0}, std::nullopt),
                     glowing(scene, square(-1.5, 0, 0.6, 1), {0, 1, 0}, false), glowing(scene, square(0, 0, 0.6, -1), {0, 0, 1}, false),
                     glowing(scene, square(1.5, 0, 0.6, -1), {1, 1, 0}, true), glowing(scene, Sphere{{0, 0, 6}, 1}, {1, 1, 1}, false)};
    const Rendered traced = render_scene(scene, ray_request({48, 36})),
                   drawn = render_scene(scene, radiance_request(Shading::phong, {48, 36}));
    unsigned differ = 0;
    for (unsigned y = 0; y < 36; ++y)
        for (unsigned x = 0; x < 48; ++x) differ += pixel(*traced.output.radiance, x, y) != pixel(*drawn.output.radiance, x, y);
    EXPECT_EQ(differ, 0u);
    EXPECT_EQ(pixel(*traced.output.radiance, 24, 18), dvec3(1, 0, 0)) << "through the back";
    EXPECT_EQ(pixel(*traced.output.radiance, 12, 18), dvec3(0, 1, 0)) << "the front";
    EXPECT_EQ(pixel(*traced.output.radiance, 35, 18), dvec3(1, 1, 0)) << "the back of one that has two sides";
}

// A mesh with normals of its own, and flat faces: an n-gon and a box.
TEST(RayAgree, DrawnAndTracedMeshesAreAlike) {
    Scene scene = headlit(plane_scene({2, 3, 4}));
    Mesh mesh;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 2; ++j) {
            const double a = i * 0.5235987755982988;
            mesh.positions.emplace_back(std::cos(a), j * 1.5, std::sin(a)), mesh.normals.emplace_back(std::cos(a), 0, std::sin(a));
        }
    mesh.face_starts = {0};
    for (std::uint32_t i = 0; i < 12; ++i) {
        const std::uint32_t j = (i + 1) % 12;
        for (const std::uint32_t c : {2 * i, 2 * i + 1, 2 * j + 1, 2 * j}) mesh.corners.push_back(c);
        mesh.face_starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    scene.meshes = {mesh};
    Object tube;
    tube.shape = MeshUse{0};
    scene.materials[0].specular = glm::vec3(0.5f), scene.objects.push_back(tube);
    expect_alike(scene, "mesh");
}

Shape convex_shape(unsigned i, std::mt19937& rng) {
    std::uniform_real_distribution<double> unit(0.05, 1);
    switch (i % 4) {
    case 0: return Sphere{{0, 0, 0}, unit(rng)};
    case 1: return Box{{-unit(rng), -unit(rng), -unit(rng)}, {unit(rng), unit(rng), unit(rng)}};
    case 2: return Cylinder{{0, -unit(rng), 0}, {0.2 * unit(rng), unit(rng), 0.1}, unit(rng)};
    default: return Cone{{0, -unit(rng), 0}, {0.1, unit(rng), 0.2 * unit(rng)}, unit(rng), 0.5 * unit(rng) - 0.025};
    }
}

glm::dmat4 random_transform(std::mt19937& rng, const dvec3& at, double exponent) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(-1, 1);
    const dvec3 x = glm::normalize(dvec3(normal(rng), normal(rng), normal(rng))),
                y = glm::normalize(glm::cross(x, dvec3(normal(rng), normal(rng), normal(rng))));
    const auto size = [&] { return std::pow(10.0, exponent * unit(rng)); };
    glm::dmat4 m(glm::dmat3(x, y, glm::cross(x, y)) * glm::dmat3(size(), 0, 0, 0, size(), 0, 0, 0, size()));
    m[3] = glm::dvec4(at, 1);
    return m;
}

// SP-4, SH-1. Convex shapes side by side under light from the eye's side: none can stand in the light of another, nor of itself, so that
// nothing is dark which the rasteriser lights. Scaled by 1 to 1/1000 along one axis.
TEST(RayAgree, AThousandConvexShapesDoNotShadowThemselves) {
    std::mt19937 rng(7);
    Scene scene;
    Camera camera;
    camera.position = {0, 0, 180}, camera.fov = 0.41;
    scene.cameras = {camera};
    scene.materials.resize(1);
    scene.materials[0].diffuse = glm::vec3(1);
    Light sun;
    sun.type = LightType::directional, sun.intensity = glm::vec3(1), sun.direction = glm::normalize(dvec3(0.02, 0.01, -1));
    scene.lights = {sun};
    for (unsigned i = 0; i < 1024; ++i) {
        Object object;
        object.shape = convex_shape(i, rng);
        object.transform = static_cast<std::uint32_t>(scene.transforms.size());
        const double narrow = std::pow(10.0, -double(i / 4 % 4));
        const dvec3 at(2.2 * (i % 32) - 34.1, 2.2 * (i / 32) - 34.1, 0);
        scene.transforms.push_back(random_transform(rng, at, 0) * glm::dmat4(narrow, 0, 0, 0, 0, 0.6, 0, 0, 0, 0, 0.6, 0, 0, 0, 0, 1));
        scene.objects.push_back(object);
    }
    const glm::uvec2 size(640, 640);
    const ImageF traced = *render_scene(scene, ray_request(size, 1)).output.radiance,
                 drawn = *render_scene(scene, radiance_request(Shading::phong, size)).output.radiance;
    unsigned dark = 0, lit = 0;
    for (unsigned y = 1; y + 1 < size.y; ++y)
        for (unsigned x = 1; x + 1 < size.x; ++x) {
            bool well_lit = true; // and so are its neighbors: no silhouette, no terminator
            for (unsigned j = 0; j < 9; ++j) well_lit &= pixel(drawn, x + j % 3 - 1, y + j / 3 - 1).x > 0.02;
            lit += well_lit, dark += well_lit && pixel(traced, x, y).x == 0;
        }
    EXPECT_EQ(dark, 0u);
    EXPECT_GT(lit, 5000u);
}

// The same one by one: alone under a light, a mirror of itself only if a mirrored ray met it again, which would glow.
TEST(RayAgree, MirroredRaysLeaveConvexShapes) {
    std::mt19937 rng(11);
    for (unsigned i = 0; i < 4; ++i) {
        Scene scene;
        scene.materials.resize(1);
        scene.materials[0].diffuse = glm::vec3(0), scene.materials[0].reflection = glm::vec3(1), scene.materials[0].emission = glm::vec3(1);
        Object object;
        object.shape = convex_shape(i, rng), object.transform = 1;
        scene.transforms.push_back(random_transform(rng, {0, 0, 0}, 1));
        scene.objects = {object};
        const ImageF image = *render_scene(scene, ray_request({64, 64}, 3)).output.radiance; // the camera is fitted
        unsigned seen = 0;
        for (unsigned y = 0; y < 64; ++y)
            for (unsigned x = 0; x < 64; ++x) {
                const double v = pixel(image, x, y).x;
                ASSERT_TRUE(v == 0 || v == 1) << i << ": " << v << " at " << x << ' ' << y;
                seen += v == 1;
            }
        EXPECT_GT(seen, 0u) << i;
    }
}

} // namespace
} // namespace lightbench::testing
