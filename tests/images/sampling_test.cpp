// Samples of the ray tracer and what becomes of them: filters wider than a pixel, adaptive sampling, crops, bands (S25, S26, AA-1, AA-4, AA-6).
#include "images/sampling_requests.h"

#include "gpu/recorder.h"
#include "image/display.h"
#include "image/metrics.h"
#include "render/raster.h"
#include "render/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lightbench::testing {
namespace {

// Few: a driver takes seconds to compile each.
const Request kSamplers[] = {traced(Sampling::jittered, Filter::box, 9), traced(Sampling::none, Filter::gaussian),
                             traced(Sampling::jittered, Filter::gaussian, 4), adaptive(3)};

// Balls that mirror each other over a floor, under one light.
Scene ball_scene() {
    Scene scene = plane_scene({3, 4, 6});
    scene.environment.ambient = glm::vec3(0.05f), scene.environment.background = {0.1f, 0.2f, 0.4f};
    Material mirror;
    mirror.diffuse = {0.2f, 0.4f, 0.8f}, mirror.reflection = glm::vec3(0.4f);
    scene.materials.push_back(mirror);
    for (const double x : {-1.0, 1.1}) {
        Object ball;
        ball.shape = Sphere{{x, 1, 0}, 1}, ball.material = 1;
        scene.objects.push_back(ball);
    }
    scene.lights = {point_light({-2, 6, 4}, glm::vec3(1))};
    return scene;
}

// Behind the camera: eye rays see the background only.
void hide_objects(Scene& scene) {
    scene.objects.resize(1);
    scene.objects[0].shape = Sphere{{9, 12, 18}, 1};
}

TEST(Sampling, LevelZeroTracesTheCornersOfPixelsOnce) {
    const Rendered r = render_scene(ball_scene(), adaptive(0));
    EXPECT_EQ(r.output.rays.value().eye, (kSize.x + 1) * (kSize.y + 1));
}

TEST(Sampling, NoContrastNoMoreRays) {
    Request request = adaptive(4);
    Scene scene = ball_scene();
    hide_objects(scene);
    EXPECT_EQ(render_scene(scene, request).output.rays.value().eye, (kSize.x + 1) * (kSize.y + 1));
    scene.environment.background = glm::vec3(0); // 0/0 of the formula as it is written (AA-1)
    EXPECT_EQ(render_scene(scene, request).output.rays.value().eye, (kSize.x + 1) * (kSize.y + 1));
}

TEST(Sampling, AConstantPictureIsConstantToTheBit) {
    Scene scene = ball_scene();
    hide_objects(scene);
    scene.environment.background = {0.1f, 1 / 3.0f, 1e-3f};
    for (const Request& request : kSamplers) {
        const ImageF image = *render_scene(scene, request).output.radiance;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
            ASSERT_EQ(image.rgba[i], 0.1f) << &request - kSamplers;
            ASSERT_EQ(image.rgba[i + 1], 1 / 3.0f) << &request - kSamplers;
            ASSERT_EQ(image.rgba[i + 2], 1e-3f) << &request - kSamplers;
            ASSERT_EQ(image.rgba[i + 3], 1.0f);
        }
    }
}

TEST(Sampling, ACropIsTheSamePartOfTheWhole) {
    const Rect crops[] = {{{13, 5}, {21, 17}}, {{47, 0}, {1, 40}}};
    for (Request request : kSamplers) {
        const ImageF whole = *render_scene(ball_scene(), request).output.radiance;
        for (const Rect& crop : crops) {
            request.crop = crop;
            const ImageF part = *render_scene(ball_scene(), request).output.radiance;
            for (unsigned y = 0; y < crop.size.y; ++y)
                for (unsigned x = 0; x < crop.size.x; ++x)
                    ASSERT_EQ(pixel(part, x, y), pixel(whole, crop.offset.x + x, crop.offset.y + y)) << x << ", " << y;
        }
    }
}

TEST(Sampling, TheSeedMovesJitteredSamplesOnly) {
    for (Request request : kSamplers) {
        const auto want = render_scene(ball_scene(), request).output.radiance->rgba;
        request.seed = 7;
        EXPECT_EQ(render_scene(ball_scene(), request).output.radiance->rgba == want, request.sampling != Sampling::jittered);
    }
}

// Renders by hand, with as little room as is asked for.
struct Narrow {
    explicit Narrow(const Request& request) : r(render_scene(ball_scene(), request)), scene(ball_scene()) {
        complete(scene, request);
        gpu_scene = upload_scene(test_device(), scene, r.geometry, r.plan);
        tracer = make_ray_tracer(test_device(), scene, r.geometry, r.plan);
        image = make_targets(test_device(), r.plan.size, 1, "radiance").resolved;
    }
    RayFrame frame() { return {r.view, r.plan.crop, glm::vec2(0.5f), 0, 0, scene.environment.ambient, scene.environment.background}; }
    RayWork work() { return {test_device(), recorder, r.plan, gpu_scene, r.geometry, times, {}, {}}; }
    std::vector<float> pixels() {
        recorder.submit_and_wait();
        return gpu::read_image<float>(test_device(), image);
    }
    Rendered r;
    Scene scene;
    GpuScene gpu_scene;
    RayTracer tracer;
    gpu::Image image;
    gpu::Recorder recorder{test_device()};
    gpu::Timings times;
};

TEST(Sampling, TilesLeaveNoSeams) {
    Narrow n(traced(Sampling::none));
    n.tracer.buffers.capacity = 64;
    const RayWork work = n.work();
    EXPECT_TRUE(trace_frame(n.tracer, work, n.frame(), n.image));
    EXPECT_EQ(n.pixels(), n.r.output.radiance->rgba);
}

// One sample a pixel goes from the ray trees to the screen; the host's display takes it by way of an image.
TEST(Sampling, OneFrameIsShownWithoutAnImage) {
    for (const Rect& crop : {Rect{{0, 0}, kSize}, Rect{{13, 5}, {21, 17}}}) {
        Request request = traced(Sampling::none);
        request.crop = crop;
        const Image8 want = display(*render_scene(ball_scene(), request).output.radiance);
        request.output = Output::pixels;
        const Rendered shown = render_scene(ball_scene(), request);
        EXPECT_FALSE(shown.plan.runs("film") || shown.plan.has("radiance"));
        const Image8& got = shown.output.pixels.value();
        ASSERT_EQ(got.rgba.size(), want.rgba.size());
        for (std::size_t i = 0; i < want.rgba.size(); ++i) ASSERT_NEAR(got.rgba[i], want.rgba[i], 1) << i; // a tie may go either way
    }
}

TEST(Sampling, WhatIsNotFiniteIsCountedWithoutAnImageToo) {
    Scene scene = ball_scene();
    hide_objects(scene);
    scene.environment.background.g = std::numeric_limits<float>::infinity();
    Request request = traced(Sampling::none);
    request.output = Output::pixels;
    EXPECT_EQ(render_scene(scene, request).output.non_finite, kSize.x * kSize.y);
}

RenderOutput render_with(Scene scene, const Request& request, const RenderOptions& options) {
    CompleteResult completed = complete(scene, request);
    const View view = completed.completed.value().view;
    const Plan plan = decide(gather_facts(scene), request, completed.completed->notes);
    const RasterGeometry geometry = tessellate(scene, tessellation_for(plan, view));
    return Renderer(test_device(), scene, geometry, plan).render(view, options);
}

TEST(Sampling, AFrameThatIsStoppedAtOnceIsBlack) {
    Request request = traced(Sampling::none);
    request.output = Output::pixels;
    RenderOptions options;
    options.stop = [] { return true; };
    const RenderOutput output = render_with(ball_scene(), request, options);
    EXPECT_EQ(output.done, 0);
    const auto& rgba = output.pixels.value().rgba;
    ASSERT_EQ(rgba.size(), 4 * kSize.x * kSize.y);
    for (std::size_t i = 0; i < rgba.size(); ++i) ASSERT_EQ(rgba[i], i % 4 == 3 ? 255 : 0);
}

TEST(Sampling, BandsAndStripsLeaveNoSeams) {
    for (const std::uint64_t room : {3u * 97, 40u * 97, 1000u}) { // a pixel row, ten of them; strips
        Narrow n(adaptive(2));
        const RayWork work = n.work();
        Lattice lattice = make_lattice(test_device(), n.r.plan, n.tracer, room);
        n.tracer.buffers.capacity = 100;
        EXPECT_TRUE(trace_adaptive(n.tracer, work, n.frame(), lattice, n.image));
        EXPECT_EQ(n.pixels(), n.r.output.radiance->rgba) << room;
        if (lattice.width == kSize.x) {
            EXPECT_EQ(n.tracer.counts.eye, n.r.output.rays.value().eye) << room; // shared rows are traced once
        }
    }
}

// Fewer rays than 62 of 117 at an error below 1/255, against uniform sampling as fine as the last level.
TEST(Sampling, AdaptiveSamplingSavesRays) {
    const Rendered r = render_scene(ball_scene(), adaptive(2));
    const Rendered uniform = render_scene(ball_scene(), traced(Sampling::uniform, Filter::box, 16));
    const double share = double(r.output.rays.value().eye) / double(uniform.output.rays.value().eye);
    double squares = 0;
    const auto &a = r.output.radiance->rgba, &b = uniform.output.radiance->rgba;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
    RecordProperty("share", std::to_string(share));
    EXPECT_LT(share, 62.0 / 117);
    RecordProperty("rms", std::to_string(std::sqrt(squares / double(a.size()) * 4 / 3)));
}

TEST(Sampling, StoppingLeavesWhatThereIs) {
    RenderOptions options;
    unsigned passes = 0;
    std::vector<float> last;
    options.pass = [&](const RenderOutput& so_far) { ++passes, last = so_far.radiance.value().rgba; };
    options.stop = [&] { return passes == 3; };
    const RenderOutput output = render_with(ball_scene(), traced(Sampling::jittered, Filter::box, 16), options);
    EXPECT_EQ(passes, 3u);
    EXPECT_DOUBLE_EQ(output.done, 3.0 / 16);
    EXPECT_EQ(output.radiance->rgba, last); // the frame that was begun does not darken the mean
}

// The levels that were whole when the stop came are the picture that --max-level of them gives: asked between generations, it comes in
// every level at some number of questions.
TEST(Sampling, AStoppedBandKeepsItsWholeLevels) {
    std::vector<std::vector<float>> levels;
    for (const unsigned level : {0u, 1u, 2u}) levels.push_back(render_scene(ball_scene(), adaptive(level)).output.radiance->rgba);
    std::vector<bool> met(3);
    bool stopped = true;
    for (unsigned patience = 0; stopped; ++patience) {
        ASSERT_LT(patience, 100u);
        RenderOptions options;
        unsigned asked = 0;
        options.stop = [&] { return asked++ >= patience; };
        const RenderOutput output = render_with(ball_scene(), adaptive(2), options);
        stopped = output.done < 1;
        const auto& got = output.radiance->rgba;
        const auto same = std::ranges::find(levels, got);
        if (same != levels.end()) met[static_cast<std::size_t>(same - levels.begin())] = true;
        const bool black = std::ranges::all_of(got, [](float x) { return x == 0; });
        EXPECT_TRUE(black || same != levels.end()) << patience;
    }
    EXPECT_EQ(met, std::vector<bool>({true, true, true}));
}

} // namespace
} // namespace lightbench::testing
