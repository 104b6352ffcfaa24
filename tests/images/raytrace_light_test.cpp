// Direct light and shadows of traced rays: S14 and S15 against closed forms at every pixel (SH-1 to SH-5), then whole ray trees of random
// scenes against the reference in double.
#include "images/ray_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lightbench::testing {
namespace {

using glm::dvec3;

constexpr double kDegree = std::numbers::pi / 180;

void expect_agreement(const Scene& scene, const Request& request, double tolerance, double most_unsure, const std::string& what) {
    const Rendered r = render_scene(scene, request);
    EXPECT_EQ(r.output.non_finite, 0u);
    const Agreement a = compare_to_reference(scene, r, {scene, request.depth, true, !request.opaque_shadows}, tolerance);
    EXPECT_EQ(a.differ, 0u) << what << ": worst " << a.worst << " at " << a.where.x << ' ' << a.where.y << " of " << a.sure;
    EXPECT_LE(a.unsure, most_unsure * (a.sure + a.unsure)) << what;
}

Scene ball_scene() {
    Scene scene = plane_scene({3, 4, 6});
    scene.environment.ambient = glm::vec3(0.05f), scene.environment.background = {0.1f, 0.2f, 0.4f};
    scene.materials[0].specular = glm::vec3(0.25f), scene.materials[0].reflection = glm::vec3(0), scene.materials[0].shininess = 20;
    Object ball;
    ball.shape = Sphere{{0, 1.2, 0}, 1};
    scene.objects.push_back(ball);
    return scene;
}

// SH-1: no speckle at any scale of the scene: sizes from 1e-4 to 1e6 m, which are not powers of two.
TEST(RayLight, APlaneAndABallAreLitAndShadowedAsTheFormulaSays) {
    for (const double s : {1.0, 1e-4, 1e6}) {
        Scene scene = ball_scene();
        scene.lights = {point_light({-2, 4, 2}, {1, 0.8f, 0.6f}, Attenuation::none),
                        point_light({2, 3, 1}, {0.2f, 0.4f, 0.5f}, Attenuation::none)};
        scene.transforms.push_back(glm::dmat4(glm::dmat3(s)));
        for (Object& o : scene.objects) o.transform = 1;
        for (Camera& c : scene.cameras) c.position *= s, c.target *= s;
        for (Light& l : scene.lights) l.position *= s;
        Request request = ray_request({96, 72});
        const Rendered r = render_scene(scene, request);
        for (Camera& c : scene.cameras) c.position /= s, c.target /= s; // the reference is for scenes of metres
        for (Light& l : scene.lights) l.position /= s;
        scene.transforms[1] = glm::dmat4(1);
        Rendered same{r.plan, r.view, {}, r.output};
        same.view.eye /= s;
        const Agreement a = compare_to_reference(scene, same, {scene});
        EXPECT_EQ(a.differ, 0u) << s << ": worst " << a.worst << " at " << a.where.x << ' ' << a.where.y;
        EXPECT_GT(a.sure, 6500u);
    }
}

// SH-2: light that grazes at 89.99 degrees, from far and from near.
TEST(RayLight, GrazingLightLeavesNoSpeckle) {
    Scene scene = plane_scene({3, 4, 6});
    Light sun;
    sun.type = LightType::directional, sun.intensity = glm::vec3(1000);
    const double a = 89.99 * kDegree;
    sun.direction = {std::sin(a), -std::cos(a), 0};
    scene.lights = {sun};
    // The direction is rounded to float: the cosine of 1.7e-4 to 2^-25 / 1.7e-4 = 2e-4.
    expect_agreement(scene, ray_request({96, 72}), 4e-4, 0.05, "sun");
    scene.lights = {point_light({-30, 34 / std::tan(a) * 0.1, 0}, glm::vec3(1000), Attenuation::none)};
    expect_agreement(scene, ray_request({96, 72}), 2e-3, 0.05, "lamp");
}

// SH-2 of a ball: the terminator, of many balls of many sizes.
TEST(RayLight, TheTerminatorOfABallIsClean) {
    Scene scene = ball_scene();
    scene.objects.erase(scene.objects.begin());
    Light sun;
    sun.type = LightType::directional, sun.direction = {1, 0, 0};
    scene.lights = {sun};
    for (const double radius : {1e-3, 0.1, 1.0, 30.0}) {
        std::get<Sphere>(scene.objects[0].shape) = {{0, 0, 0}, radius};
        scene.cameras[0].position = {0.3 * radius, 0.5 * radius, 4 * radius};
        expect_agreement(scene, ray_request({96, 72}), 1e-4, 0.1, "radius");
    }
}

// SH-3: a light inside of a closed ball lights nothing outside, and all of the inside; one behind the plane nothing of its front.
TEST(RayLight, LightsInsideAndBehind) {
    Scene scene = ball_scene();
    scene.environment.ambient = glm::vec3(0);
    scene.lights = {point_light({0.2, 1.2, 0.1}, glm::vec3(1), Attenuation::none),
                    point_light({1, -2, -1}, glm::vec3(1), Attenuation::none)};
    const Rendered dark = render_scene(scene, ray_request());
    const dvec3 background(scene.environment.background);
    for (unsigned y = 0; y < 36; ++y)
        for (unsigned x = 0; x < 48; ++x) {
            const dvec3 got = pixel(*dark.output.radiance, x, y);
            ASSERT_TRUE(got == dvec3(0) || got == background) << x << ' ' << y << ": " << got.x;
        }
    scene.cameras[0].position = {-0.3, 1.5, 0.2}, scene.cameras[0].target = {0.5, 1, -0.2};
    expect_agreement(scene, ray_request(), 1e-4, 0.02, "inside");
}

// A light on the surface itself, and one at the very point that is seen: finite.
TEST(RayLight, LightsOnTheSurfaceAreFinite) {
    for (const Attenuation law : {Attenuation::none, Attenuation::linear, Attenuation::inverse_square}) {
        Scene scene = plane_scene({0, 6, 0});
        scene.materials[0].specular = glm::vec3(0.5f);
        scene.lights = {point_light({0, 0, 0}, glm::vec3(1), law), point_light({1, 0, 0.5}, glm::vec3(1), law)};
        EXPECT_EQ(render_scene(scene, ray_request({47, 35})).output.non_finite, 0u);
    }
}

// SH-5: a light 1e6 m off and an occluder of a millimetre.
TEST(RayLight, FarLightsAndSmallThingsKeepTheirShadows) {
    Scene scene = plane_scene({0.001, 0.004, 0.006});
    scene.cameras[0].up = {0, 1, 0};
    Object bead;
    bead.shape = Sphere{{0, 0.001, 0}, 0.0005};
    scene.objects.push_back(bead);
    std::get<Polygon>(scene.objects[0].shape).points = {{-0.01, 0, 0.01}, {0.01, 0, 0.01}, {0.01, 0, -0.01}, {-0.01, 0, -0.01}};
    scene.lights = {point_light({3e5, 9e5, 2e5}, glm::vec3(1), Attenuation::none)};
    expect_agreement(scene, ray_request({96, 72}), 1e-3, 0.1, "bead");
}

// LI-6: the lights come in pieces whose shadows fit; the sum over the pieces must not stall either. Equal lights: their exact sum is known.
TEST(RayLight, ThousandsOfShadowedLightsAddUp) {
    Scene scene = ball_scene();
    scene.environment.ambient = glm::vec3(0), scene.materials[0].specular = glm::vec3(0);
    scene.materials[0].diffuse = {0.7f, 0.3f, 0.9f}, scene.materials[0].opacity = glm::vec3(1);
    Light sun;
    sun.type = LightType::directional, sun.direction = {0, -1, 0}, sun.intensity = {0.1f, 0.7f, 0.013f};
    scene.lights = {sun};
    const ImageF one = *render_scene(scene, ray_request({8, 6})).output.radiance;
    const std::size_t count = 4001;
    scene.lights.assign(count, sun);
    const ImageF many = *render_scene(scene, ray_request({8, 6})).output.radiance;
    const dvec3 background(scene.environment.background);
    double worst = 0;
    for (unsigned y = 0; y < 6; ++y)
        for (unsigned x = 0; x < 8; ++x) {
            const dvec3 term = pixel(one, x, y), sum = pixel(many, x, y);
            for (int c = 0; c < 3 && term != background; ++c)
                if (term[c] > 0) worst = std::max(worst, std::abs(sum[c] / (double(count) * term[c]) - 1));
        }
    EXPECT_LE(worst, 8 * 0x1p-24);
    EXPECT_GT(worst, 0);
}

// A light that is 5e30 of the scene's units away, squares of which no float holds, is as a directional one.
TEST(RayLight, LightsFarFromATinySceneStayFinite) {
    Scene scene = ball_scene();
    const double tiny = 1e-30, distance = std::sqrt(50.0);
    scene.transforms.push_back(glm::dmat4(glm::dmat3(tiny)));
    for (Object& o : scene.objects) o.transform = 1;
    scene.cameras[0].position *= tiny, scene.cameras[0].target *= tiny;
    const dvec3 at(3, 4, 5);
    const std::pair<Attenuation, double> laws[] = {
        {Attenuation::none, 1}, {Attenuation::linear, 1 / (distance + 1)}, {Attenuation::inverse_square, 1 / (4 * std::numbers::pi * 50)}};
    for (const auto& [law, arrives] : laws) {
        Light sun;
        sun.type = LightType::directional, sun.direction = -glm::normalize(at), sun.intensity = glm::vec3(float(arrives));
        for (Request request : {ray_request(), radiance_request(Shading::phong, {48, 36})}) {
            scene.lights = {sun};
            const ImageF want = *render_scene(scene, request).output.radiance;
            scene.lights = {point_light(at, glm::vec3(1), law)};
            const Rendered r = render_scene(scene, request);
            EXPECT_EQ(r.output.non_finite, 0u);
            for (unsigned y = 0; y < 36; ++y)
                for (unsigned x = 0; x < 48; ++x)
                    ASSERT_LE(glm::length(pixel(*r.output.radiance, x, y) - pixel(want, x, y)), 1e-5 * arrives) << x << ' ' << y;
        }
    }
}

// SH-4: a sheet just above another shadows it, down to 32 ulp of the coordinates.
TEST(RayLight, SheetsCloseTogetherStayApart) {
    for (const double gap : {1e-2, 1e-4, 32 * 4 * 0x1p-23}) {
        Scene scene = plane_scene({3, 4, 6});
        Object sheet;
        sheet.shape = Polygon{{{-4, gap, 4}, {0, gap, 4}, {0, gap, -4}, {-4, gap, -4}}, {}}, sheet.material = 1;
        Material red;
        red.diffuse = {1, 0, 0};
        scene.materials.push_back(red), scene.objects.push_back(sheet);
        scene.lights = {point_light({0, 4, 1}, glm::vec3(1), Attenuation::none)};
        expect_agreement(scene, ray_request({96, 72}), 1e-4, 0.1, fmt::format("gap {}", gap));
    }
}

Material random_material(std::mt19937& rng) {
    std::uniform_real_distribution<float> unit(0, 1);
    const auto color = [&](float most) { return most * glm::vec3(unit(rng), unit(rng), unit(rng)); };
    Material m;
    m.diffuse = color(0.8f), m.specular = color(0.3f), m.shininess = 5 + 30 * unit(rng), m.reflection = glm::vec3(0);
    switch (rng() % 5) {
    case 0: m.reflection = color(0.9f); break;
    case 1: m.diffuse *= 0.1f, m.transmission = color(0.9f), m.ior = glm::vec3(1.1f + unit(rng)); break;
    case 2: m.diffuse *= 0.1f, m.transmission = color(0.5f), m.reflection = color(0.4f), m.ior = glm::vec3(1.5f), m.fresnel = true; break;
    case 3: m.opacity = color(1); break;
    default: m.emission = color(0.3f); break;
    }
    return m;
}

// Balls, turned boxes and a floor that do not touch.
Scene random_scene(unsigned seed) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    Scene scene = plane_scene({1, 3, 8});
    scene.materials[0].reflection = glm::vec3(seed % 3 == 0 ? 0.3f : 0.0f);
    scene.environment.background = {0.2f, 0.3f, 0.5f}, scene.environment.ambient = glm::vec3(0.1f);
    for (int i = 0; i < 9; ++i) {
        const dvec3 at(2.2 * (i % 3 - 1) + 0.3 * unit(rng), 1 + 0.2 * unit(rng), 2.2 * (i / 3 - 1) + 0.3 * unit(rng));
        Object object;
        object.material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(random_material(rng));
        const auto angle = [&] { return 3 * unit(rng); };
        glm::dmat4 placed(1);
        const double a = angle(), b = angle();
        const glm::dmat3 turn = glm::dmat3(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1) *
                                glm::dmat3(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
        const glm::dmat3 size(0.8 + 0.1 * unit(rng), 0, 0, 0, rng() % 2 ? 0.8 : 0.5, 0, 0, 0, 0.7);
        placed = glm::dmat4(turn * size), placed[3] = glm::dvec4(at, 1);
        if (i % 3 == 0) object.shape = Sphere{at, 0.8};
        if (i % 3 == 1) object.shape = Box{dvec3(-0.6), dvec3(0.6)};
        if (i % 3 == 2) object.shape = Sphere{dvec3(0), 1};
        if (i % 3 > 0) scene.transforms.push_back(placed), object.transform = static_cast<std::uint32_t>(scene.transforms.size() - 1);
        scene.objects.push_back(object);
    }
    Light sun;
    sun.type = LightType::directional, sun.direction = glm::normalize(dvec3(-1, -2, -1.5)), sun.intensity = glm::vec3(0.3f);
    scene.lights = {point_light({-2, 6, 4}, {3, 2.5f, 2}, Attenuation::linear), sun,
                    point_light({3, 5, 0}, glm::vec3(200), Attenuation::inverse_square)};
    return scene;
}

// S13 to S16, S19: the whole tree.
TEST(RayTree, RandomScenesAgreeWithTheReference) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        Request request = ray_request({40, 30}, 2 + seed);
        request.opaque_shadows = seed % 2 == 0;
        // What mirrors and lenses enlarge is a good part of such pictures.
        expect_agreement(random_scene(seed), request, 5e-4, 0.6, fmt::format("seed {}", seed));
    }
}

// The test of the test: a reference with a wrong index of refraction is found out.
TEST(RayTree, TheReferenceWouldTell) {
    Scene scene = random_scene(1);
    Request request = ray_request({40, 30}, 5);
    request.opaque_shadows = true;
    const Rendered r = render_scene(scene, request);
    for (Material& m : scene.materials) m.ior *= 1.01f;
    EXPECT_GT(compare_to_reference(scene, r, {scene, 5, true, false}, 5e-4).differ, 5u);
}

} // namespace
} // namespace lightbench::testing
