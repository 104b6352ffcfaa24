// Exact transparency: S13 and TR-1 to TR-5 against the formula in double; order, tiles and lights must not matter.
#include "images/rendering.h"
#include "shared/effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace lightbench::testing {
namespace {

using glm::dvec3;
using glm::vec3;

// Panes across the view of a camera that looks down the z axis; each glows, so that nothing but S13 is computed.
Scene panes_scene(vec3 background) {
    Scene scene;
    Camera camera;
    camera.position = {0, 0, 10};
    scene.cameras = {camera};
    scene.environment.background = background;
    return scene;
}

void add_pane(Scene& scene, double z, vec3 glow, vec3 t, double tilt = 0) {
    Material material;
    material.diffuse = vec3(0), material.emission = glow, material.opacity = t;
    scene.materials.push_back(material);
    Object pane;
    pane.shape = Polygon{{{-9, -9, z - 9 * tilt}, {9, -9, z + 9 * tilt}, {9, 9, z + 9 * tilt}, {-9, 9, z - 9 * tilt}}, {}};
    pane.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    scene.objects.push_back(pane);
}

Rendered draw(const Scene& scene, glm::uvec2 size = {16, 12}) {
    return render_scene(scene, radiance_request(Shading::phong, size));
}

dvec3 closed_form(unsigned n, vec3 t, vec3 front, vec3 back) {
    dvec3 result;
    for (int c = 0; c < 3; ++c) {
        const double through = std::pow(1 - static_cast<double>(t[c]), n);
        result[c] = front[c] * (1 - through) + back[c] * through;
    }
    return result;
}

// Units in the last place of `want`.
double ulps(double got, double want) {
    int exponent = 0;
    std::frexp(want, &exponent);
    return std::abs(got - want) / std::ldexp(1.0, exponent - 24);
}

void expect_layers(unsigned n, bool apart) {
    const vec3 front(0.9f, 0.4f, 0.1f), back(0.05f, 0.3f, 0.8f), t(0.03f, 0.25f, 0.5f);
    Scene scene = panes_scene(back);
    for (unsigned i = 0; i < n; ++i) add_pane(scene, apart ? -1e-3 * i : 0, front, t);
    const Rendered r = draw(scene);
    const dvec3 want = closed_form(n, t, front, back), got = pixel(*r.output.radiance, 7, 5);
    for (int c = 0; c < 3; ++c)
        EXPECT_LE(ulps(got[c], want[c]), 2.0 * n) << n << " layers, channel " << c << ": " << got[c] << " for " << want[c];
}

TEST(Layers, IdenticalLayersHaveAClosedForm) {
    for (const unsigned n : {1u, 2u, 3u, 4u, 5u, 8u, 9u, 16u, 17u, 31u, 33u, 100u, 1000u}) expect_layers(n, true);
}

TEST(Layers, CoincidentLayersAllCount) {
    for (const unsigned n : {2u, 16u, 40u}) expect_layers(n, false);
}

TEST(Layers, TheFormulaOfTwoLayersPerChannel) {
    Scene scene = panes_scene({0.2f, 0.4f, 0.6f});
    add_pane(scene, -1, {0.5f, 0.1f, 0.3f}, {0.25f, 0.5f, 1});
    add_pane(scene, 1, {0.9f, 0.8f, 0.7f}, {0.75f, 0.0f, 0.125f});
    const dvec3 got = pixel(*draw(scene).output.radiance, 8, 6);
    EXPECT_NEAR(got.x, 0.75 * 0.9 + 0.25 * (0.25 * 0.5 + 0.75 * 0.2), 2e-7);
    EXPECT_NEAR(got.y, 0.5 * 0.1 + 0.5 * 0.4, 2e-7);
    EXPECT_NEAR(got.z, 0.125 * 0.7 + 0.875 * 0.3, 2e-7);
}

// Panes that cut through one another, panes in one plane with different looks, more of them than registers hold.
Scene tangle(unsigned panes) {
    Scene scene = panes_scene({0.1f, 0.2f, 0.3f});
    std::mt19937 random(7);
    std::uniform_real_distribution<float> one(0.05f, 0.95f);
    for (unsigned i = 0; i < panes; ++i)
        add_pane(scene, i % 3 == 0 ? 0 : one(random), {one(random), one(random), one(random)}, {one(random), one(random), one(random)},
                 i % 3 == 0 ? 0 : one(random) - 0.5);
    return scene;
}

TEST(Layers, TheOrderOfObjectsDoesNotMatter) {
    for (const unsigned panes : {6u, 15u, 40u}) {
        Scene scene = tangle(panes);
        const std::vector<float> first = draw(scene, {64, 48}).output.radiance->rgba;
        std::mt19937 random(panes);
        for (int round = 0; round < 3; ++round) {
            std::shuffle(scene.objects.begin(), scene.objects.end(), random);
            EXPECT_EQ(draw(scene, {64, 48}).output.radiance->rgba, first) << panes << " panes, round " << round;
        }
    }
}

// A few pixels with many more layers than the others, each sorted by itself.
TEST(Layers, PixelsOfVeryDifferentDepth) {
    Scene scene = tangle(17);
    const std::vector<float> shallow = draw(scene, {64, 48}).output.radiance->rgba;
    Material clear;
    clear.diffuse = vec3(0), clear.opacity = vec3(0.001f);
    scene.materials.push_back(clear);
    for (int i = 0; i < 3000; ++i) {
        Object patch;
        const double z = 2 + 1e-3 * i, side = 0.1;
        patch.shape = Polygon{{{-side, -side, z}, {side, -side, z}, {side, side, z}, {-side, side, z}}, {}};
        patch.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        scene.objects.push_back(patch);
    }
    const std::vector<float> deep = draw(scene, {64, 48}).output.radiance->rgba;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < deep.size(); i += 4) differing += deep[i] != shallow[i];
    EXPECT_GT(differing, 0u);
    EXPECT_LE(differing, 16u) << "the patch covers a few pixels in the middle";
}

// Intersecting panes against the formula, evaluated per pixel by the planes' equations.
TEST(Layers, IntersectingPanesAreInOrderInEveryPixel) {
    Scene scene = panes_scene(vec3(0.1f));
    const vec3 glow[2] = {{0.9f, 0.1f, 0.2f}, {0.1f, 0.8f, 0.3f}};
    add_pane(scene, 0, glow[0], vec3(0.5f), 0.5), add_pane(scene, 0, glow[1], vec3(0.25f), -0.5);
    const Rendered r = draw(scene, {64, 48});
    for (unsigned x = 0; x < 64; ++x) {
        if (x == 31 || x == 32) continue; // the panes meet there
        const bool left = x < 32;         // the first pane lies lower, so farther away, on the left
        const unsigned near = left ? 1 : 0;
        const float t[2] = {0.5f, 0.25f};
        const double want = t[near] * glow[near].x + (1 - t[near]) * (t[1 - near] * glow[1 - near].x + (1 - t[1 - near]) * 0.1);
        EXPECT_NEAR(pixel(*r.output.radiance, x, 24).x, want, 4e-7) << x;
    }
}

// TR-1: what is fully hidden, and what is fully clear, may be infinite.
TEST(Layers, WhatNobodySeesMayBeInfinite) {
    const float infinite = std::numeric_limits<float>::infinity();
    Scene hidden = panes_scene(vec3(0.1f));
    add_pane(hidden, 0, vec3(infinite), vec3(0.5f));
    add_pane(hidden, 1, {0.25f, 0.5f, 0.75f}, {1, 1, 0.999999f});
    hidden.materials[0].emission.z = 0;
    const dvec3 got = pixel(*draw(hidden).output.radiance, 8, 6);
    EXPECT_EQ(got.x, 0.25);
    EXPECT_EQ(got.y, 0.5);
    Scene clear = panes_scene(vec3(0.1f));
    add_pane(clear, 0, {infinite, infinite, 1}, {0, 0, 0.5f});
    EXPECT_EQ(pixel(*draw(clear).output.radiance, 8, 6).x, static_cast<double>(0.1f));
}

TEST(Layers, OpaqueSurfacesHideAndShowThrough) {
    Scene scene = panes_scene(vec3(0));
    add_pane(scene, 0, vec3(1), vec3(1)); // opaque
    add_pane(scene, 1, vec3(0.5f), vec3(0.5f));
    add_pane(scene, -1, vec3(100), vec3(0.5f));
    EXPECT_EQ(pixel(*draw(scene).output.radiance, 8, 6).x, 0.75);
}

struct Budget {
    explicit Budget(const char* bytes) { setenv("LIGHTBENCH_MEMORY_BUDGET", bytes, 1); }
    ~Budget() { unsetenv("LIGHTBENCH_MEMORY_BUDGET"); }
};

// Lists that do not fit are made tile by tile, down to a few pixels; where not even one pixel fits, that is said.
TEST(Layers, TilesChangeNoByte) {
    const Scene scene = tangle(20);
    const std::vector<float> whole = draw(scene, {64, 48}).output.radiance->rgba;
    for (const char* budget : {"1M", "64K", "2K"}) { // 16384, 1024 and 32 records a tile
        const Budget low(budget);
        EXPECT_EQ(draw(scene, {64, 48}).output.radiance->rgba, whole) << budget;
    }
    const Budget none("1K");
    EXPECT_THROW(draw(scene, {64, 48}), gpu::EnvironmentError);
}

TEST(Layers, ACropIsThatPartOfTheImage) {
    const Scene scene = tangle(20);
    const Rendered whole = draw(scene, {64, 48});
    Request request = radiance_request(Shading::phong, {64, 48});
    request.crop = Rect{{13, 7}, {21, 30}};
    const Rendered part = render_scene(scene, request);
    for (unsigned y = 0; y < 30; ++y)
        for (unsigned x = 0; x < 21; ++x)
            ASSERT_EQ(pixel(*part.output.radiance, x, y), pixel(*whole.output.radiance, x + 13, y + 7)) << x << ' ' << y;
}

// Four samples a pixel are four shifted frames, each with lists of its own.
TEST(Layers, SamplesAreFramesOfTheirOwn) {
    Request request = radiance_request(Shading::phong, {64, 48});
    request.spp = 4;
    const Rendered r = render_scene(tangle(5), request);
    EXPECT_EQ(r.plan.multisamples, 1u);
    EXPECT_EQ(r.plan.frames, 4u);
    EXPECT_EQ(r.output.non_finite, 0u);
    request.spp = 1;
    Scene opaque = tangle(5);
    for (Material& m : opaque.materials) m.opacity = vec3(1);
    request.spp = 4;
    EXPECT_EQ(render_scene(opaque, request).plan.multisamples, 4u);
}

// All modes shade translucent surfaces by the one model: seen straight on under a directional light they agree.
TEST(Layers, AllShadingModesListTheirFragments) {
    Scene scene = panes_scene(vec3(0.2f));
    add_pane(scene, 0, vec3(0.1f), vec3(0.5f)), add_pane(scene, 1, vec3(0.3f), {0.25f, 0.5f, 0.75f});
    for (Material& m : scene.materials) m.diffuse = {0.8f, 0.6f, 0.4f};
    Light sun;
    sun.type = LightType::directional, sun.direction = glm::normalize(dvec3(0.3, -0.4, -1));
    scene.lights = {sun};
    std::vector<dvec3> got;
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong})
        got.push_back(pixel(*render_scene(scene, radiance_request(shading, {16, 12})).output.radiance, 8, 6));
    EXPECT_LT(glm::length(got[0] - got[2]), 1e-6);
    EXPECT_LT(glm::length(got[1] - got[2]), 1e-6);
    EXPECT_GT(got[0].x, 0.2);
}

// The layers of a file add up to its image: blending is linear in what is blended.
TEST(Layers, TermsAddUp) {
    Scene scene = tangle(3); // no two in one plane: coincident fragments are ordered by what they look like, in each term apart
    scene.environment.ambient = vec3(0.2f);
    for (Material& m : scene.materials) m.diffuse = {0.8f, 0.6f, 0.4f}, m.specular = vec3(0.3f);
    scene.lights = {point_light({2, 3, 8}, vec3(5))};
    Request request = radiance_request(Shading::phong, {32, 24});
    request.terms = true;
    const Rendered r = render_scene(scene, request);
    for (unsigned y = 0; y < 24; ++y)
        for (unsigned x = 0; x < 32; ++x) {
            dvec3 sum(0);
            for (const Layer& layer : r.output.layers)
                if (layer.name != "attenuation" && layer.name != "normal" && layer.name != "depth" && layer.name != "object")
                    sum += pixel(layer.image, x, y);
            ASSERT_LT(glm::length(sum - pixel(*r.output.radiance, x, y)), 2e-6) << x << ' ' << y;
        }
}

TEST(Layers, OpaqueScenesHaveNoneOfIt) {
    Scene scene = panes_scene(vec3(0.1f));
    add_pane(scene, 0, vec3(1), vec3(1));
    const Rendered r = draw(scene);
    EXPECT_FALSE(r.plan.effects & EFFECT_TRANSPARENCY);
    for (const char* pass : {"count-layers", "list-layers", "blend-layers"}) EXPECT_FALSE(r.plan.runs(pass)) << pass;
    for (const char* resource : {"layers", "layer-counts", "layer-blocks"}) EXPECT_FALSE(r.plan.has(resource)) << resource;
    ASSERT_EQ(r.output.times.size(), 1u);
    EXPECT_EQ(r.output.times[0].name, "raster");
}

} // namespace
} // namespace lightbench::testing
