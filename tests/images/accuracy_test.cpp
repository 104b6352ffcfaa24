// How errors fall where theory knows it: shading with subdivision, edges with samples, radiosity with shots. (Hemi-cubes: hemicube_error_test.)
#include "images/radiosity_rooms.h"
#include "images/sampling_requests.h"

#include "image/metrics.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lightbench::testing {
namespace {

// Of log2(error) a doubling of x, by least squares; every error is below the one before.
double slope_of(const std::vector<double>& errors, double doublings = 1) {
    const double n = static_cast<double>(errors.size()), mean = (n - 1) / 2;
    double xy = 0, xx = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double x = static_cast<double>(i) - mean;
        xy += x * std::log2(errors[i]), xx += x * x;
        if (i > 0) {
            EXPECT_LT(errors[i], errors[i - 1]) << i;
        }
    }
    return xy / xx / doublings;
}

// A diffuse ball under a sun behind the camera: what is seen is lit, without highlight or terminator, and smooth.
Scene chalk_ball() {
    Scene scene = plane_scene({0, 0, 3});
    scene.objects[0].shape = Sphere{};
    scene.environment.background = glm::vec3(0);
    Light sun;
    sun.type = LightType::directional, sun.direction = {0, 0, -1};
    scene.lights = {sun};
    return scene;
}

// Beside Phong on the same facets, so that the outline counts for nothing: a constant and a linear interpolation of what is smooth err by the
// first and the second power of an edge.
TEST(Accuracy, ShadingErrorsFallWithSubdivision) {
    std::vector<double> flat, gouraud;
    for (unsigned level = 0; level < 4; ++level) {
        const auto drawn = [&](Shading shading) {
            Request request = radiance_request(shading, {160, 120});
            request.subdivide = level;
            return render_scene(chalk_ball(), request).output.radiance.value();
        };
        const ImageF phong = drawn(Shading::phong);
        flat.push_back(metrics(phong, drawn(Shading::flat)).rmse), gouraud.push_back(metrics(phong, drawn(Shading::gouraud)).rmse);
    }
    EXPECT_NEAR(slope_of(flat), -1, 0.1) << fmt::format("{}", fmt::join(flat, " "));
    EXPECT_NEAR(slope_of(gouraud), -2, 0.1) << fmt::format("{}", fmt::join(gouraud, " "));
}

constexpr unsigned kStrips = kSize.x / 2;

double edge_of(unsigned strip) {
    return 8 + std::fmod(0.5 + 0.6180339887498949 * strip, 1); // y, m; spread evenly over a pixel
}

// Strips two pixels wide that glow up to a height of their own; a pixel of the plane z = 0 is 1 m wide.
Scene strips() {
    Scene scene = plane_scene({0, 0, 1});
    scene.environment.background = glm::vec3(0);
    scene.cameras[0].fov = 2 * std::atan(kSize.y / 2.0);
    scene.materials[0].diffuse = glm::vec3(0), scene.materials[0].emission = glm::vec3(1);
    scene.objects.clear();
    for (unsigned i = 0; i < kStrips; ++i) {
        const double x = 2.0 * i - kSize.x / 2.0, y = edge_of(i);
        Object strip;
        strip.shape = Polygon{{{x, -19, 0}, {x + 2, -19, 0}, {x + 2, y, 0}, {x, y, 0}}, {}};
        scene.objects.push_back(strip);
    }
    return scene;
}

// Root mean square over the pixels that an edge crosses.
double edge_error(Sampling sampling, unsigned spp) {
    const ImageF image = *render_scene(strips(), traced(sampling, Filter::box, spp)).output.radiance;
    double squares = 0;
    for (unsigned x = 0; x < kSize.x; ++x) {
        const double off = pixel(image, x, kSize.y / 2 - 9).x - (edge_of(x / 2) - 8);
        squares += off * off;
    }
    return std::sqrt(squares / kSize.x);
}

// m x m cells of which an edge along the grid crosses a row. Uniform samples: the row is in or out, an error that is even within 1 / (2m).
// Jittered: m independent decisions of variance 1/6 in the mean over heights (Mitchell 1996).
TEST(Accuracy, EdgesComeOutWithSamples) {
    std::vector<double> uniform, jittered;
    for (const unsigned m : {1u, 2u, 4u, 8u, 16u}) {
        uniform.push_back(edge_error(Sampling::uniform, m * m)), jittered.push_back(edge_error(Sampling::jittered, m * m));
        EXPECT_NEAR(uniform.back() * m, 1 / std::sqrt(12.0), 0.04) << m;
        EXPECT_NEAR(jittered.back() * std::pow(m, 1.5), 1 / std::sqrt(6.0), 0.12) << m; // 48 samples of it: three standard deviations
    }
    EXPECT_NEAR(slope_of(uniform, 2), -0.5, 0.05) << fmt::format("{}", fmt::join(uniform, " "));
    EXPECT_NEAR(slope_of(jittered, 2), -0.75, 0.1) << fmt::format("{}", fmt::join(jittered, " "));
}

class Shots : public gpu::GpuTest {};

// What is not shot yet is all that is missing: no element overshoots, and every shot brings the whole nearer.
TEST_F(Shots, BringEveryElementNearer) {
    const Room room = random_room(100, 4, 0.8f, 3);
    const std::vector<glm::dvec3> exact = room.direct_solution();
    ProgressiveSolver solver(device(), room.mesh, room.emission, room.reflectance, 4);
    double last = 1e300;
    for (int batch = 0; batch < 40; ++batch) {
        ASSERT_GT(shoot_batch(device(), solver, room, 4), 0u);
        const RadiosityState now = solver.state();
        double missing = 0;
        for (std::size_t i = 0; i < exact.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const double less = exact[i][c] - static_cast<double>(now.radiosity[i][c]);
                EXPECT_GE(less, -1e-5 * exact[i][c]);
                missing += room.areas[i] * less;
            }
        EXPECT_LT(missing, last) << batch;
        last = missing;
    }
}

} // namespace
} // namespace lightbench::testing
