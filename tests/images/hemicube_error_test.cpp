// Where hemi-cubes err, and what is done about it: small elements, the horizon, near elements (HC-3, HC-6, HC-10).
#include "hemicube_fixture.h"

#include "radiosity/form_factors.h"

#include <fmt/format.h>

namespace lightbench {

// HC-6: of what is no larger than a pixel of the hemi-cube, one patch sees too much and the next nothing; 64 that are turned differently
// see what falls off with the square of the distance.
TEST_F(Hemicube, AliasingAveragesOut) {
    PatchMesh mesh;
    std::vector<std::uint32_t> patches, targets;
    for (unsigned i = 0; i < 64; ++i)
        patches.push_back(add_grid(mesh, {{-0.01, -0.01, 0}, {0.02, 0, 0}, {0, 0.02, 0}, 1, 1, 1}).first_patch);
    std::vector<double> exact;
    for (int i = 0; i < 1024; ++i) { // half a pixel wide, apart from each other
        const glm::dvec3 c(0.8 * (i % 32 - 15.7), 0.8 * (i / 32 - 15.4), 24), x(0.4, 0, 0), y(0, 0.4, 0);
        targets.push_back(add_grid(mesh, {c - 0.5 * (x + y), y, x, 1, 1, 1}).first_element);
        const glm::dvec3 q[] = {c - 0.5 * (x + y), c + 0.5 * (y - x), c + 0.5 * (x + y), c + 0.5 * (x - y)};
        exact.push_back(point_to_polygon({0, 0, 0}, {0, 0, 1}, q));
    }
    const auto rows = rows_of(mesh, {.resolution = 64, .batch = 64}, patches);
    double mean = 0, most = 0;
    for (std::size_t t = 0; t < targets.size(); ++t)
        for (const auto& row : rows) {
            const double ratio = row[targets[t]] / exact[t] / kHemicubeOne;
            mean += ratio / static_cast<double>(rows.size() * targets.size()), most = std::max(most, ratio);
        }
    fmt::print("over the exact form factor: at most {:.2f}, in the mean {:.4f}\n", most, mean);
    EXPECT_GT(most, 1.3);
    EXPECT_NEAR(mean, 1, 0.01);
}

// Elements that edges of pixels cut: about N of the N^2 pixels err, in or out as a whole (between -1 and -1.5). Root mean square over
// directions, since of a single element the error may be anything down to 0.
TEST_F(Hemicube, ErrorsFallWithTheResolution) {
    PatchMesh mesh;
    std::vector<std::uint32_t> patches, targets;
    for (unsigned i = 0; i < 8; ++i)
        patches.push_back(add_grid(mesh, {{-0.01, -0.01, 0}, {0.02, 0, 0}, {0, 0.02, 0}, 1, 1, 1}).first_patch);
    std::vector<double> exact;
    for (int i = 0; i < 64; ++i) {
        const glm::dvec3 c(1.7 * (i % 8 - 3.4), 1.7 * (i / 8 - 3.6), 4), x(1.3, 0, 0), y(0, 1.3, 0);
        targets.push_back(add_grid(mesh, {c - 0.5 * (x + y), y, x, 1, 1, 1}).first_element);
        const glm::dvec3 q[] = {c - 0.5 * (x + y), c + 0.5 * (y - x), c + 0.5 * (x + y), c + 0.5 * (x - y)};
        exact.push_back(point_to_polygon({0, 0, 0}, {0, 0, 1}, q));
    }
    std::vector<double> errors;
    for (const unsigned n : {16u, 32u, 64u, 128u, 256u}) {
        double squares = 0;
        for (const auto& row : rows_of(mesh, {.resolution = n, .batch = 8}, patches))
            for (std::size_t t = 0; t < targets.size(); ++t) {
                const double off = row[targets[t]] / exact[t] / kHemicubeOne - 1;
                squares += off * off;
            }
        errors.push_back(std::sqrt(squares / static_cast<double>(patches.size() * targets.size())));
        if (errors.size() > 1) {
            EXPECT_LT(errors.back(), errors[errors.size() - 2]) << n;
        }
    }
    const double slope = std::log2(errors.back() / errors.front()) / 4;
    fmt::print("relative errors {:.3g}, slope {:.2f}\n", fmt::join(errors, " "), slope);
    EXPECT_GE(slope, -1.6);
    EXPECT_LE(slope, -0.9);
}

// HC-10: what lies in the patch's plane or behind it gets nothing, what crosses its horizon what is above; with and without correction.
TEST_F(Hemicube, Horizon) {
    PatchMesh mesh;
    const glm::dvec3 o(0.123, 0.456, 0.789);
    const AddedGrid from = add_grid(mesh, {o, {1, 0, 0}, {0, 1, 0}, 1, 1, 1});
    const AddedGrid beside = add_grid(mesh, {o + glm::dvec3(1, 0, 0), {1, 0, 0}, {0, 1, 0}, 3, 3, 3});
    const AddedGrid behind = add_grid(mesh, {o + glm::dvec3(0, 0, -1), {1, 0, 0}, {0, 1, 0}, 2, 2, 2});
    const AddedGrid away = add_grid(mesh, {o + glm::dvec3(0, 0, 1), {1, 0, 0}, {0, 1, 0}, 2, 2, 2}); // above, its back turned to the patch
    const AddedGrid across = add_grid(mesh, {o + glm::dvec3(-2, 0, -1), {0, 1, 0}, {0, 0, 2}, 8, 8, 8}); // half of it below
    const glm::dvec3 seen[] = {o + glm::dvec3(-2, 0, 0), o + glm::dvec3(-2, 1, 0), o + glm::dvec3(-2, 1, 1), o + glm::dvec3(-2, 0, 1)};
    const glm::dvec3 patch[] = {o, o + glm::dvec3(0, 1, 0), o + glm::dvec3(1, 1, 0), o + glm::dvec3(1, 0, 0)};
    const std::vector<glm::dvec3> from_front(std::rbegin(patch), std::rend(patch));
    double from_elements = 0;
    for (std::uint32_t i = 0; i < across.elements; ++i) {
        const Element& e = mesh.elements[across.first_element + i];
        if (e.center.z > o.z) from_elements += point_to_polygon(e.center, e.normal, from_front) * e.area;
    }
    for (HemicubeWay way : {HemicubeWay::rays, HemicubeWay::raster})
        for (bool near : {false, true}) {
            const HemicubeRequest request{.resolution = 256, .batch = 1, .way = way, .correct_near = near};
            for (const AddedGrid& none : {from, beside, behind, away}) EXPECT_EQ(between(mesh, from, none, request), 0);
            const double exact = near ? from_elements : point_to_polygon(o + glm::dvec3(0.5, 0.5, 0), {0, 0, 1}, seen);
            EXPECT_NEAR(between(mesh, from, across, request) / exact, 1, near ? 5e-3 : 0.01);
        }
}

// HC-3: from centres alone opposite unit squares half a side apart are 33 % too near.
TEST_F(Hemicube, NearElementsAreCorrected) {
    for (const double d : {0.5, 1.0, 2.0}) {
        PatchMesh mesh;
        const AddedGrid from = add_grid(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4, 4});
        const AddedGrid to = add_grid(mesh, {{0, 0, d}, {0, 1, 0}, {1, 0, 0}, 4, 4, 4});
        const double exact = parallel_rectangles(1, 1, d);
        const double plain = between(mesh, from, to, {.resolution = 128, .batch = 1}) / exact - 1;
        const double corrected = between(mesh, from, to, {.resolution = 128, .batch = 1, .correct_near = true}) / exact - 1;
        fmt::print("distance {}: {:+.2f} %, corrected {:+.2f} %\n", d, 100 * plain, 100 * corrected);
        EXPECT_NEAR(plain, d == 0.5 ? 0.33 : d == 1 ? 0.198 : 0.071, 0.01);
        EXPECT_LT(std::abs(corrected), 0.015);
    }
}

// With a screen halfway that hides a half: rays find it.
TEST_F(Hemicube, NearElementsAreSeenPastScreens) {
    PatchMesh mesh;
    const AddedGrid from = add_grid(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4, 4});
    const AddedGrid to = add_grid(mesh, {{0, 0, 0.5}, {0, 1, 0}, {1, 0, 0}, 8, 8, 8});
    add_grid(mesh, {{0.5, 0, 0.001}, {0, 0, 0.498}, {0, 1, 0}, 1, 1, 1});
    const double f = between(mesh, from, to, {.resolution = 64, .batch = 1, .correct_near = true, .near_rays = 64});
    EXPECT_NEAR(f / parallel_rectangles(0.5, 1, 0.5), 1, 0.05);
}

} // namespace lightbench
