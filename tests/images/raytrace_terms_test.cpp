// --terms of traced rays: the light terms add up to the image, what shadows take away is known, and facts of surfaces are those that the
// rasteriser sees.
#include "images/ray_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lightbench::testing {
namespace {

using glm::dvec3;

const ImageF& layer(const Rendered& r, std::string_view name) {
    const auto found = std::ranges::find(r.output.layers, name, &Layer::name);
    if (found == r.output.layers.end()) throw std::runtime_error(fmt::format("no layer {}", name));
    return found->image;
}

// Over a floor under one light: a mirror, a glass ball, a pane that half of the light passes, and a block.
Scene terms_scene() {
    Scene scene = plane_scene({1, 3, 7});
    scene.environment.ambient = glm::vec3(0.05f), scene.environment.background = {0.1f, 0.2f, 0.4f};
    scene.materials[0].specular = glm::vec3(0.25f), scene.materials[0].emission = {0.02f, 0, 0};
    Material mirror, glass, pane;
    mirror.diffuse = glm::vec3(0.2f), mirror.reflection = {0.7f, 0.6f, 0.5f};
    glass.diffuse = glm::vec3(0.05f), glass.reflection = glm::vec3(0.1f), glass.transmission = glm::vec3(0.85f),
    glass.ior = glm::vec3(1.5f);
    pane.diffuse = {0.8f, 0.1f, 0.1f}, pane.opacity = glm::vec3(0.5f);
    scene.materials.insert(scene.materials.end(), {mirror, glass, pane});
    const auto add = [&](auto shape, std::uint32_t material) {
        Object object;
        object.shape = shape, object.material = material;
        scene.objects.push_back(object);
    };
    add(Sphere{{-1.5, 1, 0}, 1}, 1), add(Sphere{{1, 1, 1}, 0.8}, 2);
    add(Box{{-0.4, 0, 1.8}, {0.4, 1.2, 1.9}}, 3), add(Box{{1.4, 0, -2}, {2.4, 1, -1}}, 0);
    scene.lights = {point_light({-2, 6, 4}, glm::vec3(1))};
    return scene;
}

TEST(RayTerms, AddUpToTheImage) {
    Request jittered = ray_request({64, 48}, 5), gaussian = jittered;
    jittered.sampling = Sampling::jittered, jittered.spp = 4, jittered.cutoff = 0.01f;
    gaussian.filter = Filter::gaussian;
    for (Request request : {jittered, gaussian}) {
        request.terms = true;
        const Rendered r = render_scene(terms_scene(), request);
        constexpr std::array<const char*, 7> kLight = {"ambient",   "diffuse",   "specular",  "emission",
                                                       "reflected", "refracted", "background"};
        const auto& image = r.output.radiance->rgba;
        std::vector<float> sum(image.size());
        for (const char* name : kLight) {
            const auto& part = layer(r, name).rgba;
            EXPECT_GT(*std::ranges::max_element(part), 0.01f) << name << " is black";
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            if (i % 4 == 3) continue;
            ASSERT_NEAR(sum[i], image[i], 2e-6f * (1 + image[i])) << i;
        }
    }
}

// The floor's diffuse light and what the shadows took of it are together Lambert's law.
TEST(RayTerms, ShadowIsWhatTheLightsWouldHaveAdded) {
    Request request = ray_request({64, 48}, 5);
    request.terms = true;
    Scene scene = terms_scene();
    for (Material& m : scene.materials) m.specular = glm::vec3(0);
    const Rendered r = render_scene(scene, request);
    unsigned floor = 0, dark = 0;
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            if (pixel(layer(r, "object"), x, y).x != 1) continue;
            const dvec3 d = r.view.direction_through({x + 0.5, y + 0.5}), p = r.view.eye - d * (r.view.eye.y / d.y);
            const dvec3 l = glm::normalize(dvec3(-2, 6, 4) - p), taken = pixel(layer(r, "shadow"), x, y);
            const dvec3 lit = pixel(layer(r, "diffuse"), x, y) + taken, want = l.y * dvec3(scene.materials[0].diffuse);
            ASSERT_LT(glm::length(lit - want), 2e-6) << x << ' ' << y;
            ++floor, dark += taken.x > 0;
        }
    EXPECT_GT(floor, 500u);
    EXPECT_GT(dark, 50u);
    EXPECT_LT(dark, floor);
}

TEST(RayTerms, FactsOfSurfacesAreThoseOfTheRasteriser) {
    Request rays = ray_request({64, 48}, 5), raster = radiance_request(Shading::phong);
    rays.terms = raster.terms = true;
    const Rendered a = render_scene(terms_scene(), rays), b = render_scene(terms_scene(), raster);
    unsigned same = 0;
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            const double object = pixel(layer(a, "object"), x, y).x;
            if (object != pixel(layer(b, "object"), x, y).x) continue; // an edge between two samples
            ++same;
            if (object == 0) {
                ASSERT_EQ(pixel(layer(a, "depth"), x, y).x, 0);
                continue;
            }
            // Balls are cut to a quarter of a pixel, 7 / 48 / 4 of a metre here at most: along a ray at 60 degrees from the normal twice that,
            // which turns the normal of a ball of 0.8 m by 0.09.
            const bool flat = object == 1 || object > 3;
            const dvec3 normal = pixel(layer(a, "normal"), x, y);
            if (!flat && glm::dot(normal, a.view.direction_through({x + 0.5, y + 0.5})) > -0.5) continue;
            const double depth = pixel(layer(b, "depth"), x, y).x;
            ASSERT_NEAR(pixel(layer(a, "depth"), x, y).x, depth, flat ? 1e-5 * depth : 0.073) << x << ' ' << y;
            ASSERT_LT(glm::length(normal - pixel(layer(b, "normal"), x, y)), flat ? 1e-5 : 0.1) << x << ' ' << y;
        }
    EXPECT_GT(same, 64u * 48 * 97 / 100);
}

// What nobody sends on, shadows or mirrors has no layer.
TEST(RayTerms, OnlyOfWhatIsThere) {
    Scene scene = plane_scene({1, 3, 7});
    scene.lights = {point_light({-2, 6, 4}, glm::vec3(1))};
    Request request = ray_request({16, 12}, 5);
    request.terms = true;
    const Rendered r = render_scene(scene, request);
    for (const char* name : {"reflected", "refracted", "emission", "background"})
        EXPECT_EQ(std::ranges::count(r.plan.terms, name), 0) << name;
    EXPECT_EQ(r.output.layers.size(), r.plan.terms.size());
}

} // namespace
} // namespace lightbench::testing
