// Radiosity from scene to image: closed rooms against the furnace, the Cornell box against a path tracer, lights without area, resuming.
#include "images/rendering.h"

#include "image/file_bytes.h"
#include "scene/make.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lightbench {
namespace {

using namespace testing;

Request radiosity_request(glm::uvec2 size = {64, 48}) {
    Request request = radiance_request(Shading::gouraud, size);
    request.method = Method::radiosity;
    return request;
}

Scene made(const char* kind) {
    return std::get<Scene>(make_scene(kind, {}));
}

// A closed cube of side 2 about the origin, seen from inside; all of it glows and reflects alike.
Scene furnace(float radiance, float rho) {
    Scene scene;
    scene.materials.emplace_back();
    scene.materials[0].diffuse = glm::vec3(rho), scene.materials[0].emission = glm::vec3(radiance, 2 * radiance, radiance / 4);
    scene.materials[0].two_sided = false;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Polygon face;
            for (const glm::dvec2& corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
                glm::dvec3 p;
                p[axis] = side, p[(axis + 1) % 3] = corner.x, p[(axis + 2) % 3] = corner.y;
                face.points.push_back(p);
            }
            if (side > 0) std::ranges::reverse(face.points); // inwards
            scene.objects.push_back({face});
        }
    scene.cameras.push_back({.name = "inside", .position = {0.5, 0.3, 0.7}, .target = {-1, 0, -1}});
    return scene;
}

double largest_error(const ImageF& image, const glm::dvec3& expected) {
    double worst = 0;
    for (unsigned y = 0; y < image.height; ++y)
        for (unsigned x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::fabs(pixel(image, x, y)[c] / expected[c] - 1));
    return worst;
}

TEST(Radiosity, TheFirstImageOfAUniformRoomIsTheFurnace) { // RS-5
    Request request = radiosity_request();
    request.radiosity.shots = 0, request.radiosity.element = request.radiosity.patch = 0.5;
    const Rendered rendered = render_scene(furnace(1, 0.6f), request);
    EXPECT_LE(largest_error(*rendered.output.radiance, glm::dvec3(1, 2, 0.25) / 0.4), 1e-5);
    EXPECT_EQ(rendered.output.radiosity->shots, 0u);
}

TEST(Radiosity, AClosedRoomConvergesToTheFurnace) { // RS-1
    Request request = radiosity_request();
    request.radiosity.element = request.radiosity.patch = 0.5, request.radiosity.until = 1e-4, request.radiosity.ambient = false;
    request.radiosity.correct_near = false; // rows that sum to 1
    const Rendered rendered = render_scene(furnace(1, 0.6f), request);
    EXPECT_LE(largest_error(*rendered.output.radiance, glm::dvec3(1, 2, 0.25) / 0.4), 0.05); // shots from centres: percents in corners
    EXPECT_LE(rendered.output.radiosity->unshot, 1e-4);
}

TEST(Radiosity, TheFullMatrixOfAClosedRoomIsTheFurnace) {
    Request request = radiosity_request();
    request.radiosity.patch = 0.5, request.radiosity.solver = Solver::full, request.radiosity.correct_near = false;
    const Rendered rendered = render_scene(furnace(1, 0.6f), request);
    EXPECT_LE(largest_error(*rendered.output.radiance, glm::dvec3(1, 2, 0.25) / 0.4), 1e-4); // gathered: every row sums to 1
    EXPECT_LE(rendered.output.radiosity->closure_error, 1e-6);
}

glm::dvec3 mean_of(const ImageF& image, unsigned y0, unsigned y1, unsigned x0, unsigned x1) {
    glm::dvec3 sum(0);
    for (unsigned y = y0; y < y1; ++y)
        for (unsigned x = x0; x < x1; ++x) sum += pixel(image, x, y);
    return sum / double((y1 - y0) * (x1 - x0));
}

// Means of a path tracer's picture (Mitsuba 3, 1024 samples a pixel) of 512 x 512, here at half the size.
TEST(Radiosity, TheCornellBoxIsThatOfAPathTracer) {
    Request request = radiosity_request({256, 256});
    request.radiosity.element = 40, request.radiosity.patch = 120, request.radiosity.until = 0.01;
    const ImageF image = *render_scene(made("cornell-box"), request).output.radiance;
    const struct {
        const char* name;
        unsigned y0, y1, x0, x1;
        glm::dvec3 expected;
    } regions[] = {{"back", 75, 100, 115, 145, {.2924, .1949, .0567}},
                   {"red wall", 100, 150, 10, 30, {.1533, .0110, .0026}},
                   {"green wall", 100, 150, 225, 245, {.0389, .0817, .0051}},
                   {"ceiling", 10, 20, 60, 90, {.0744, .0357, .0088}}};
    for (const auto& r : regions) {
        const glm::dvec3 mean = mean_of(image, r.y0, r.y1, r.x0, r.x1);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / r.expected[c], 1, 0.05) << r.name << ", channel " << c;
    }
}

TEST(Radiosity, AKilledRunGoesOnBitByBit) {
    const std::string path = (std::filesystem::path(::testing::TempDir()) / "resume_test.lbrad").string();
    std::filesystem::remove(path);
    Scene scene = made("cornell-box");
    const auto render = [&](unsigned shots, const std::string& solution) {
        Scene copy = scene;
        Request request = radiosity_request();
        request.radiosity.element = 80, request.radiosity.patch = 160, request.radiosity.shots = shots;
        CompleteResult result = complete(copy, request);
        const View view = result.completed->view;
        request.size = view.size;
        const Plan plan = decide(gather_facts(copy), request);
        const RasterGeometry geometry = tessellate(copy, tessellation_for(plan, view));
        RenderOptions options;
        options.solution = solution;
        return Renderer(test_device(), copy, geometry, plan).render(view, options);
    };
    const RenderOutput whole = render(100, "");
    const std::uint64_t first = whole.radiosity->curve[1].shots; // where a submission ends
    render(static_cast<unsigned>(first), path);
    const RenderOutput resumed = render(100, path);
    EXPECT_EQ(resumed.radiosity->shots, whole.radiosity->shots);
    EXPECT_EQ(resumed.radiance->rgba, whole.radiance->rgba);
    scene.materials[0].diffuse *= 0.5f;
    EXPECT_THROW(render(100, path), FileError); // the solution of another scene
    std::filesystem::remove(path);
}

// One light over one floor, which sees nothing else: the first shot is all, and it is what the rasteriser draws.
TEST(Radiosity, LightsWithoutAreaFeedSurfaces) {
    Scene scene = plane_scene({0, 3, 0.1});
    scene.lights.push_back(point_light({0.3, 1, 0.2}, glm::vec3(2, 1, 0.5f), Attenuation::inverse_square));
    Request request = radiosity_request();
    const ImageF drawn = *render_scene(scene, radiance_request(Shading::phong)).output.radiance;
    request.radiosity.element = 0.02, request.radiosity.patch = 0.1, request.radiosity.shots = 0, request.radiosity.ambient = false;
    const Rendered rendered = render_scene(scene, request);
    EXPECT_TRUE(rendered.plan.runs("feed"));
    double most = 0;
    for (unsigned y = 0; y < drawn.height; ++y)
        for (unsigned x = 0; x < drawn.width; ++x) most = std::max(most, pixel(drawn, x, y).x);
    ASSERT_GT(most, 0);
    for (unsigned y = 8; y < drawn.height - 8; ++y)
        for (unsigned x = 8; x < drawn.width - 8; ++x)
            EXPECT_NEAR(pixel(*rendered.output.radiance, x, y).x, pixel(drawn, x, y).x, 0.01 * most) << x << ", " << y;
}

TEST(Radiosity, AnySceneOfPrimitivesIsSolved) {
    Request request = radiosity_request();
    request.radiosity.shots = 40;
    const Rendered rendered = render_scene(made("primitives"), request);
    EXPECT_EQ(rendered.output.non_finite, 0u);
    EXPECT_GT(rendered.output.radiosity->elements, 1000u);
    EXPECT_GT(mean_of(*rendered.output.radiance, 16, 32, 16, 48).x, 0.001);
}

} // namespace
} // namespace lightbench
