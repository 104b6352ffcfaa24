// Surface detail in pictures: what must not change beside it, seams that show no line, and each effect gone from the code where no scene
// calls for it.
#include "gpu/pipeline.h"
#include "images/rendering.h"
#include "render/raster.h"
#include "shared/effects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lightbench::testing {
namespace {

using glm::dvec3;
using glm::vec3;

// Two balls under one light, each with a material of its own.
Scene two_balls() {
    Scene scene;
    Camera camera;
    camera.position = {0, 0, 6};
    scene.cameras = {camera};
    scene.materials.resize(2);
    scene.lights = {point_light({2, 3, 5}, vec3(5))};
    for (const double x : {-1.2, 1.2}) {
        Object ball;
        ball.shape = Sphere{{x, 0, 0}, 1};
        ball.material = x < 0 ? 0 : 1;
        scene.objects.push_back(ball);
    }
    return scene;
}

// A picture in memory: binary, flat Radiance HDR.
std::uint32_t add_picture(Scene& scene, unsigned width, unsigned height, auto&& value) {
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
    Picture picture;
    picture.file = "made.hdr";
    picture.encoded.assign(head.begin(), head.end());
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x) {
            const auto byte = static_cast<unsigned char>(255 * value(x, y));
            picture.encoded.insert(picture.encoded.end(), {byte, byte, byte, 128});
        }
    scene.pictures.push_back(std::move(picture));
    return static_cast<std::uint32_t>(scene.pictures.size() - 1);
}

using Change = void (*)(Scene&);
struct Row {
    const char* name;
    std::uint32_t bits;
    Change change;
};

const Row kRows[] = {
    {"gaussian", EFFECT_GAUSSIAN, [](Scene& s) { s.materials[0].model = Model::cook_torrance, s.materials[0].specular = vec3(1); }},
    {"beckmann", EFFECT_BECKMANN,
     [](Scene& s) {
         s.materials[0].model = Model::cook_torrance, s.materials[0].distribution = Distribution::beckmann;
         s.materials[0].specular = vec3(1);
     }},
    {"checker", EFFECT_CHECKER, [](Scene& s) { s.materials[0].texture.emplace(); }},
    {"texture", EFFECT_TEXTURE,
     [](Scene& s) {
         s.materials[0].texture.emplace().picture = add_picture(s, 16, 8, [](auto x, auto y) { return (x ^ y) & 1 ? 0.9 : 0.2; });
     }},
    {"waves", EFFECT_BUMP_WAVES,
     [](Scene& s) { s.materials[0].bump.emplace().function = BumpFunction::waves, s.materials[0].bump->amplitude = 0.1; }},
    {"noise", EFFECT_BUMP_NOISE,
     [](Scene& s) {
         s.materials[0].bump.emplace().function = BumpFunction::noise, s.materials[0].bump->amplitude = 0.1,
         s.materials[0].bump->frequency = 3;
     }},
    {"height image", EFFECT_BUMP_HEIGHT,
     [](Scene& s) {
         s.materials[0].bump.emplace().amplitude = 0.2;
         s.materials[0].bump->picture =
             add_picture(s, 64, 32, [](auto x, auto y) { return 0.5 + 0.4 * std::sin(0.4 * x) * std::cos(0.4 * y); });
     }},
    {"normal map", EFFECT_NORMAL_MAP,
     [](Scene& s) {
         s.materials[0].bump.emplace().normal_map = true, s.materials[0].bump->amplitude = 1;
         s.materials[0].bump->picture = add_picture(s, 16, 8, [](auto x, auto) { return x & 1 ? 0.7 : 0.4; });
     }},
    {"environment", EFFECT_MIRROR_ENVIRONMENT | EFFECT_BACKGROUND_MAP,
     [](Scene& s) {
         s.materials[0].environment = 0.8f;
         s.environment.map = {add_picture(s, 16, 8, [](auto x, auto y) { return 0.05 * (x + y); })};
     }},
    {"rendered environment", EFFECT_MIRROR_ENVIRONMENT | EFFECT_RENDERED_CUBE, [](Scene& s) { s.materials[0].environment = 0.8f; }},
    {"transparency", EFFECT_TRANSPARENCY,
     [](Scene& s) {
         s.materials[0].opacity = {0.2f, 0.5f, 0.8f};
     }},
};

std::size_t words_of(const Scene& scene, const Rendered& r) {
    const GpuScene on_gpu = upload_scene(test_device(), scene, r.geometry, r.plan);
    const RasterPipelines made =
        make_raster_pipelines(test_device(), r.plan, on_gpu, r.geometry, {r.plan.effects, OUTPUT_RADIANCE, r.plan.multisamples});
    const SurfacePipelines& s = made.surfaces;
    return (s.two_sided ? s.two_sided : s.one_sided).fragment()->words.size();
}

// One ball has the effect, the other has not: that one is drawn as it is alone, bit by bit, in every shading; the picture is finite.
TEST(Detail, AnEffectOfOneMaterialLeavesTheOtherAlone) {
    for (const Row& row : kRows)
        for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
            Scene scene = two_balls();
            row.change(scene);
            if (!scene.environment.map.empty()) continue; // its background is everywhere
            const Rendered with = render_scene(scene, radiance_request(shading)),
                           without = render_scene(two_balls(), radiance_request(shading));
            EXPECT_EQ(with.output.non_finite, 0u) << row.name;
            EXPECT_TRUE(with.plan.effects & row.bits) << row.name;
            double change = 0;
            for (unsigned y = 0; y < 48; ++y) {
                for (unsigned x = 36; x < 64; ++x)
                    EXPECT_LT(glm::length(pixel(*with.output.radiance, x, y) - pixel(*without.output.radiance, x, y)), 2e-5)
                        << row.name << ' ' << x << ' ' << y;
                for (unsigned x = 0; x < 28; ++x)
                    change = std::max(change, glm::length(pixel(*with.output.radiance, x, y) - pixel(*without.output.radiance, x, y)));
            }
            EXPECT_GT(change, 0.005) << row.name << " changes nothing";
        }
}

// Without it the fragment stage is exactly that of a scene that never knew of it, and longer with it.
TEST(Detail, AnEffectThatIsNotCalledForIsGoneFromTheCode) {
    const Scene plain = two_balls();
    const Rendered plain_picture = render_scene(plain, radiance_request(Shading::phong));
    const std::size_t plain_words = words_of(plain, plain_picture);
    for (const Row& row : kRows) {
        EXPECT_FALSE(plain_picture.plan.effects & row.bits) << row.name;
        Scene scene = two_balls();
        row.change(scene);
        const Rendered with = render_scene(scene, radiance_request(Shading::phong));
        if (row.bits != EFFECT_TRANSPARENCY) {
            EXPECT_GT(words_of(scene, with), plain_words + 50) << row.name;
        }
        scene.materials[0] = Material{}, scene.environment.map.clear();
        const Rendered removed = render_scene(scene, radiance_request(Shading::phong));
        EXPECT_EQ(words_of(scene, removed), plain_words) << row.name;
        EXPECT_EQ(removed.plan.passes.size(), plain_picture.plan.passes.size()) << row.name;
        EXPECT_EQ(removed.plan.resources.size(), plain_picture.plan.resources.size()) << row.name;
    }
}

// S11: a bump tilts normals; which pixels are covered, and how far away they are, stays.
TEST(Detail, BumpsLeaveTheSilhouette) {
    Request request = radiance_request(Shading::phong, {96, 72});
    request.terms = true;
    const auto depths = [&](const Scene& scene) {
        for (const Layer& layer : render_scene(scene, request).output.layers)
            if (layer.name == "depth") return layer.image.rgba;
        return std::vector<float>();
    };
    const auto smooth = depths(two_balls());
    ASSERT_FALSE(smooth.empty());
    for (const Row& row : kRows)
        if (row.bits & EFFECT_ANY_BUMP) {
            Scene scene = two_balls();
            row.change(scene);
            EXPECT_EQ(depths(scene), smooth) << row.name;
        }
}

// TX-5: a picture that is the same all around shows no line where u jumps from 1 to 0, and none at the poles, from near and from far.
TEST(Detail, TheSeamAndThePolesShowNoLine) {
    for (const double distance : {2.5, 40.0})
        for (const dvec3& from : {dvec3(0, 0, -1), dvec3(0, 0, 1), dvec3(0, 1, 0.01), dvec3(0, -1, 0.01)}) {
            Scene scene = two_balls();
            scene.objects.resize(1);
            scene.objects[0].shape = Sphere{{0, 0, 0}, 1};
            scene.cameras[0].position = from * distance, scene.cameras[0].fov = 2 * std::asin(1.2 / distance);
            scene.lights = {point_light({0, 0, 9}, vec3(0))}; // none at all would be a headlight
            scene.environment.ambient = vec3(1);
            scene.materials[0].diffuse = vec3(1);
            const Rendered plain = render_scene(scene, radiance_request(Shading::phong));
            scene.materials[0].texture.emplace().mapping = Mapping::spherical;
            scene.materials[0].texture->picture = add_picture(scene, 256, 128, [](auto, auto) { return 0.5; });
            const Rendered r = render_scene(scene, radiance_request(Shading::phong));
            double least = 1e9, most = 0;
            for (unsigned y = 0; y < 48; ++y)
                for (unsigned x = 0; x < 64; ++x) {
                    if (pixel(*plain.output.radiance, x, y).x < 0.99) continue;
                    least = std::min(least, pixel(*r.output.radiance, x, y).x), most = std::max(most, pixel(*r.output.radiance, x, y).x);
                }
            EXPECT_LT(most - least, 1e-6) << distance;
            EXPECT_GT(least, 0.1);
        }
}

// A checkered floor far away is its mean: filtered, not aliased.
TEST(Detail, FarAwayTheCheckerIsItsMean) {
    Scene scene = plane_scene({0, 6, 0.5});
    scene.lights = {point_light({0, 0, 9}, vec3(0))};
    scene.environment.ambient = vec3(1);
    scene.materials[0].diffuse = vec3(1);
    scene.materials[0].texture.emplace().mapping = Mapping::planar;
    scene.materials[0].texture->scale = glm::dvec2(2000);
    const Rendered r = render_scene(scene, radiance_request(Shading::phong));
    for (unsigned x = 24; x < 40; ++x) EXPECT_NEAR(pixel(*r.output.radiance, x, 24).x, 0.6, 0.02) << x; // squares of 1 and 0.2
}

// Six faces of one color are that color from everywhere; faces of very different brightness are all kept.
TEST(Detail, SixFacesSurroundTheScene) {
    Scene scene = two_balls();
    scene.objects.clear();
    for (int face = 0; face < 6; ++face)
        scene.environment.map.push_back(add_picture(scene, 8, 8, [&](auto, auto) { return 0.1 * (face + 1); }));
    const dvec3 ways[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0.001}, {0, -1, 0.001}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face) {
        scene.cameras[0].position = {0, 0, 0}, scene.cameras[0].target = ways[face];
        const Rendered r = render_scene(scene, radiance_request(Shading::phong, {16, 16}));
        EXPECT_NEAR(pixel(*r.output.radiance, 8, 8).x, std::floor(25.5 * (face + 1)) / 256, 2e-3) << face;
    }
}

// The picture's alpha counts where the material says so, and only there.
TEST(Detail, AlphaOfAPictureIsOpacityWhereItIsAskedFor) {
    Scene scene = two_balls();
    scene.materials[0].texture.emplace().picture = add_picture(scene, 16, 8, [](auto, auto) { return 0.9; });
    EXPECT_FALSE(render_scene(scene, radiance_request(Shading::phong)).plan.effects & EFFECT_TRANSPARENCY);
    scene.materials[0].texture->alpha = true;
    const Rendered r = render_scene(scene, radiance_request(Shading::phong));
    EXPECT_TRUE(r.plan.effects & EFFECT_TRANSPARENCY && r.plan.effects & EFFECT_TEXTURE_ALPHA);
    EXPECT_EQ(r.output.non_finite, 0u);
}

} // namespace
} // namespace lightbench::testing
