// What samples make of edges and of things smaller than a pixel: shares of pixels against exact areas (AA-2, AA-3, AA-5).
#include "images/sampling_requests.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <random>

namespace lightbench::testing {
namespace {

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

// Of pixel (x, y): the part below that line, by clipping the square.
double covered_share(double degrees, unsigned x, unsigned y) {
    const double a = degrees * std::numbers::pi / 180;
    const glm::dvec2 corner(x - 0.5 * kSize.x, y - 0.5 * kSize.y), below(std::sin(a), std::cos(a)); // y down
    const std::array<glm::dvec2, 4> square{corner, corner + glm::dvec2(1, 0), corner + glm::dvec2(1), corner + glm::dvec2(0, 1)};
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 p = square[i], q = square[(i + 1) % 4];
        const double hp = glm::dot(p, below), hq = glm::dot(q, below);
        if (hp >= 0) kept.push_back(p);
        if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) kept.push_back(p + hp / (hp - hq) * (q - p));
    }
    double twice = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const glm::dvec2 p = kept[i], q = kept[(i + 1) % kept.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return std::abs(twice) / 2;
}

// 20 x 20 glowing squares of `side` pixels on black, each two pixels from the next and somewhere in its pixel. The share that is not seen.
double missed_dots(Request request, double side) {
    request.size = {48, 48};
    Scene scene = half_plane(0);
    scene.cameras[0].fov = 2 * std::atan(24.0); // a pixel of the plane z = 0 is 1 m wide
    scene.objects.erase(scene.objects.begin());
    std::mt19937 rng(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 400; ++i) {
        const double x = 4 + 2 * (i % 20) + unit(rng) - 24, y = 4 + 2 * (i / 20) + unit(rng) - 24, w = side;
        Object dot;
        dot.shape = Polygon{{{x, y, 0}, {x + w, y, 0}, {x + w, y + w, 0}, {x, y + w, 0}}, {}};
        scene.objects.push_back(dot);
    }
    const ImageF image = *render_scene(scene, request).output.radiance;
    unsigned missed = 0;
    for (unsigned i = 0; i < 400; ++i) { // a dot may reach into the pixels to its right and above, and y grows downwards in the picture
        const unsigned x = 4 + 2 * (i % 20), y = 47 - (4 + 2 * (i / 20));
        missed += pixel(image, x, y).x + pixel(image, x + 1, y).x + pixel(image, x, y - 1).x + pixel(image, x + 1, y - 1).x == 0;
    }
    return missed / 400.0;
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
    const Request samplers[] = {adaptive(4), traced(Sampling::jittered, Filter::box, 64), traced(Sampling::uniform, Filter::box, 64)};
    const double samples[] = {256, 64, 64};
    for (int sampler = 0; sampler < 3; ++sampler) {
        double bias = 0, squares = 0;
        int angles = 0, on_edge = 0;
        for (double degrees = 0; degrees <= 90; degrees += 15, ++angles) {
            const ImageF image = *render_scene(half_plane(degrees), samplers[sampler]).output.radiance;
            double sum = 0;
            for (unsigned y = 0; y < kSize.y; ++y)
                for (unsigned x = 0; x < kSize.x; ++x) {
                    const double got = pixel(image, x, y).x, want = covered_share(degrees, x, y);
                    sum += got;
                    if (want > 0 && want < 1) squares += (got - want) * (got - want), ++on_edge;
                }
            bias += std::abs(sum / double(kSize.x * kSize.y) - 0.5); // a line through the middle halves the picture
        }
        EXPECT_LE(bias / angles, 1e-3) << sampler;
        EXPECT_LE(std::sqrt(squares / on_edge), 1 / (2 * std::sqrt(samples[sampler]))) << sampler;
        RecordProperty(fmt::format("rms {}", sampler), std::to_string(std::sqrt(squares / on_edge)));
    }
}

// AA-3: dots a quarter of a pixel wide that no corner of a cell meets are missed, and how often is what a model says: a dot is seen if a
// point of the lattice lies in it, pixel corners at 0; of the jittered samples, n to a pixel, if one of them does.
TEST(Sampling, SmallDotsAreMissedAsOftenAsTheModelSays) {
    const double side = 0.25; // pixels
    const double corners = missed_dots(adaptive(2), side), jittered = missed_dots(traced(Sampling::jittered, Filter::box, 4), side),
                 fine = missed_dots(traced(Sampling::jittered, Filter::box, 16), side);
    // 400 dots: three standard deviations of a share are at most 3 * 0.5 / 20.
    EXPECT_NEAR(corners, 1 - side * side, 0.075);
    EXPECT_LE(jittered, std::pow(1 - side * side, 4) + 0.075);
    EXPECT_LE(fine, std::pow(1 - side * side, 16) + 0.075);
    RecordProperty("missed", fmt::format("{} {} {}", corners, jittered, fine));
}

} // namespace
} // namespace lightbench::testing
