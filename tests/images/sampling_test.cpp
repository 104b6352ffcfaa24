// Samples of the ray tracer and what becomes of them: filters wider than a pixel, adaptive sampling, crops, bands (S25, S26, AA-1 to AA-6).
#include "images/rendering.h"

#include "gpu/recorder.h"
#include "image/metrics.h"
#include "render/raster.h"
#include "render/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lightbench::testing {
namespace {

constexpr glm::uvec2 kSize{48, 40};

Request traced(Sampling sampling, Filter filter = Filter::box, unsigned spp = 1) {
    Request request = radiance_request(Shading::phong, kSize);
    request.method = Method::raytrace, request.sampling = sampling, request.filter = filter, request.spp = spp;
    request.count = true;
    return request;
}

Request adaptive(unsigned max_level) {
    Request request = traced(Sampling::adaptive);
    request.max_level = max_level;
    return request;
}

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

// What glows below the line through the picture's middle at this angle, before black.
Scene half_plane(double degrees) {
    Scene scene = plane_scene({0, 0, 1});
    scene.environment.background = glm::vec3(0);
    scene.cameras[0].up = {0, 1, 0};
    scene.materials.push_back(scene.materials[0]);
    Object behind; // the camera; lit
    behind.shape = Sphere{{0, 0, 9}, 1}, behind.material = 1;
    scene.objects.push_back(behind);
    scene.lights = {point_light({0, 0, 5}, glm::vec3(1))};
    scene.materials[0].diffuse = glm::vec3(0), scene.materials[0].emission = glm::vec3(1);
    const double a = degrees * std::numbers::pi / 180;
    const glm::dvec3 along(std::cos(a), std::sin(a), 0), below(std::sin(a), -std::cos(a), 0);
    scene.objects[0].shape = Polygon{{-9.0 * along, -9.0 * along + 9.0 * below, 9.0 * along + 9.0 * below, 9.0 * along}, {}};
    return scene;
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

// AA-2: an edge splits its cells to the last level and no others.
TEST(Sampling, AKnifeEdgeIsFoundToTheLastLevel) {
    for (const unsigned level : {1u, 3u, 6u}) {
        const Rendered r = render_scene(half_plane(0.0), adaptive(level));
        const double side = std::exp2(level);
        EXPECT_LE(double(r.output.rays.value().eye), double(kSize.x * side + 1) * (side + 1) * 2 + (kSize.x + 1) * (kSize.y + 1));
        double covered = 0;
        for (unsigned y = 0; y < kSize.y; ++y) covered += pixel(*r.output.radiance, 7, y).x;
        EXPECT_NEAR(covered, kSize.y / 2.0, 1 / side) << level;
    }
}

// AA-5: rms of the covered share of pixels on the edge against the finest uniform grid, and no bias.
TEST(Sampling, RotatedHalfPlanesAreCoveredWithoutBias) {
    double bias = 0;
    int angles = 0;
    for (double degrees = 0; degrees <= 90; degrees += 15, ++angles) {
        const ImageF image = *render_scene(half_plane(degrees), adaptive(4)).output.radiance;
        double sum = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i];
        bias += std::abs(sum / double(kSize.x * kSize.y) - 0.5); // a line through the middle halves the picture
    }
    EXPECT_LE(bias / angles, 1e-3);
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
    Scene scene = ball_scene();
    const Request request = traced(Sampling::jittered, Filter::box, 16);
    CompleteResult completed = complete(scene, request);
    const View view = completed.completed.value().view;
    const Plan plan = decide(gather_facts(scene), request, completed.completed->notes);
    const RasterGeometry geometry = tessellate(scene, tessellation_for(plan, view));
    Renderer renderer(test_device(), scene, geometry, plan);
    RenderOptions options;
    unsigned passes = 0;
    std::vector<float> last;
    options.pass = [&](const RenderOutput& so_far) { ++passes, last = so_far.radiance.value().rgba; };
    options.stop = [&] { return passes == 3; };
    const RenderOutput output = renderer.render(view, options);
    EXPECT_EQ(passes, 3u);
    EXPECT_DOUBLE_EQ(output.done, 3.0 / 16);
    EXPECT_EQ(output.radiance->rgba, last); // the frame that was begun does not darken the mean
}

} // namespace
} // namespace lightbench::testing
