// Hemi-cubes against closed forms: anchors, closed rooms, screens, both ways of making them (HC-1, HC-2, HC-4, HC-7, HC-9).
#include "hemicube_fixture.h"

#include "radiosity/form_factors.h"
#include "render/radiosity/hemicube_state.h"

#include <fmt/format.h>

namespace lightbench {
namespace {

const bool kLong = std::getenv("LIGHTBENCH_LONG_TESTS") != nullptr;

struct Anchor {
    const char* name;
    double a, b, c; // the shooter is a x b at 0; the receiver lies opposite at c, or stands on the edge of length a, c high
    bool parallel;
    double expected() const { return parallel ? parallel_rectangles(a, b, c) : perpendicular_rectangles(a, b, c); }
};
const Anchor kAnchors[] = {{"parallel squares", 1, 1, 1, true},
                           {"parallel 2 x 1", 2, 1, 1, true},
                           {"perpendicular squares", 1, 1, 1, false},
                           {"perpendicular 1 to 2", 1, 1, 2, false},
                           {"perpendicular 2 to 1", 1, 2, 1, false}};

struct TwoGrids {
    PatchMesh mesh;
    AddedGrid from, to;
};

// Off the axes, so that no plane is at a whole number.
TwoGrids make_anchor(const Anchor& a, unsigned n) {
    TwoGrids g;
    const glm::dvec3 o(-0.413, -0.287, -0.351);
    g.from = add_grid(g.mesh, {o, {a.a, 0, 0}, {0, a.b, 0}, n, n, 1});
    g.to = a.parallel ? add_grid(g.mesh, {o + glm::dvec3(0, 0, a.c), {0, a.b, 0}, {a.a, 0, 0}, 4, 4, 4})
                      : add_grid(g.mesh, {o, {0, 0, a.c}, {a.a, 0, 0}, 4, 4, 4});
    return g;
}

} // namespace

// HC-4: 1e-4 at 512 pixels and 32 x 32 patches.
TEST_F(Hemicube, Anchors) {
    fmt::print("error of the form factor; patches along an edge, pixels of the hemi-cube\n");
    for (const Anchor& a : kAnchors)
        for (unsigned pixels : {64u, 128u, 256u, 512u})
            for (unsigned n : {1u, 2u, 4u, 8u, 16u, 32u}) {
                const bool finest = pixels == 512 && n == 32;
                if (!kLong && !(pixels == 64 && n <= 16)) continue;
                const TwoGrids g = make_anchor(a, n);
                // Few triangles and many pixels: there drawing is faster.
                const HemicubeRequest request{
                    .resolution = pixels, .batch = 16, .way = pixels > 64 ? HemicubeWay::raster : HemicubeWay::rays};
                const double error = between(g.mesh, g.from, g.to, request) - a.expected();
                fmt::print("{:22} {:3} {:4} {:+.2e}\n", a.name, n, pixels, error);
                EXPECT_LT(std::abs(error), finest ? 1e-4 : n >= 16 ? 2e-3 : 0.1) << a.name << ' ' << n << ' ' << pixels;
            }
}

// HC-1, HC-2: every pixel of a closed room has an element, and rows sum to one exactly; the top and the sides apart.
TEST_F(Hemicube, ClosedBox) {
    for (HemicubeWay way : {HemicubeWay::rays, HemicubeWay::raster})
        for (unsigned n : {32u, 50u, 64u}) {
            const PatchMesh mesh = closed_box(8, 4);
            const HemicubeRequest request{.resolution = n, .batch = 5, .way = way};
            Hemicubes cubes(device(), mesh, request);
            const auto rows = rows_of(cubes, mesh, request, all_patches(mesh));
            for (std::size_t i = 0; i < rows.size(); ++i) {
                EXPECT_EQ(std::accumulate(rows[i].begin(), rows[i].end(), std::uint64_t{0}), kHemicubeOne) << i << ", " << n << " pixels";
                const Patch& p = mesh.patches[i];
                for (std::uint32_t e = 0; e < p.count; ++e) EXPECT_EQ(rows[i][p.first + e], 0u); // F_ii = 0
            }
            for (unsigned k = 0; k < mesh.patches.size() % 5; ++k) {
                const auto items = cubes.items(k);
                EXPECT_EQ(std::count(items.begin(), items.end(), kNoElement), 0);
            }
        }
}

// The elements that the top and each side see, by where they must be: the contract of shaders/shared/radiosity.h.
TEST_F(Hemicube, ItemsAreInOrder) {
    for (HemicubeWay way : {HemicubeWay::rays, HemicubeWay::raster}) {
        const PatchMesh mesh = closed_box(8, 8);
        const unsigned n = 64;
        const HemicubeRequest request{.resolution = n, .batch = 6, .way = way};
        Hemicubes cubes(device(), mesh, request);
        rows_of(cubes, mesh, request, all_patches(mesh));
        std::vector<gpu_layout::Shooter> shooters(6);
        gpu::download(device(), cubes.shooters(), std::as_writable_bytes(std::span(shooters)));
        std::size_t wrong = 0;
        for (unsigned k = 0; k < 6; ++k) {
            const auto items = cubes.items(k);
            const glm::dvec3 normal = shooters[k].normal, tangent = shooters[k].tangent, bitangent = glm::cross(normal, tangent);
            for (unsigned i = 0; i < 3 * n * n; ++i) {
                const unsigned row = i / n, face = row < n ? 0 : 1 + (row - n) / (n / 2);
                const double u = (i % n + 0.5) * 2 / n - 1, v = face == 0 ? (row + 0.5) * 2 / n - 1 : ((row - n) % (n / 2) + 0.5) * 2 / n;
                const glm::dvec3 out = face == 0   ? normal
                                       : face <= 2 ? tangent * (face == 1 ? 1.0 : -1.0)
                                                   : bitangent * (face == 3 ? 1.0 : -1.0);
                const glm::dvec3 d = out + u * (face == 1 || face == 2 ? bitangent : tangent) + v * (face == 0 ? bitangent : normal);
                const glm::dvec3 far = (glm::dvec3(1) - glm::sign(d) * glm::dvec3(shooters[k].center)) / glm::abs(d);
                const glm::dvec3 p = glm::dvec3(shooters[k].center) + d * std::min(far.x, std::min(far.y, far.z));
                ASSERT_LT(items[i], mesh.elements.size());
                const Element& e = mesh.elements[items[i]];
                const glm::dvec3 off = glm::abs(p - e.center);
                wrong += std::max(off.x, std::max(off.y, off.z)) > 0.125 + 0.02; // half an element, and some of a pixel
            }
        }
        EXPECT_EQ(wrong, 0u);
    }
}

// Pixels that differ lie next to one that sees another element. The rasteriser rounds corners to 1/256 of a pixel.
TEST_F(Hemicube, BothWaysAgree) {
    PatchMesh mesh = closed_box(12, 4);
    add_grid(mesh, {{-0.3, -0.4, -0.1}, {0.5, 0.1, 0.2}, {0, 0.6, 0.1}, 5, 5, 5});
    std::vector<std::vector<std::uint32_t>> items;
    const unsigned n = 64;
    const std::vector<std::uint32_t> patches{0, 5, 17, 30, 44, 53};
    for (HemicubeWay way : {HemicubeWay::rays, HemicubeWay::raster}) {
        const HemicubeRequest request{.resolution = n, .batch = 6, .way = way};
        Hemicubes cubes(device(), mesh, request);
        rows_of(cubes, mesh, request, patches);
        for (unsigned k = 0; k < patches.size(); ++k) items.push_back(cubes.items(k));
    }
    std::size_t differ = 0, inside = 0, pixels = 0;
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const auto &a = items[k], &b = items[k + patches.size()];
        pixels += a.size();
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (a[i] == b[i]) continue;
            ++differ;
            bool edge = i % n == 0 || i % n == n - 1 || i <= n || i + n + 1 >= a.size();
            for (int step : {-65, -64, -63, -1, 1, 63, 64, 65})
                if (!edge) edge = a[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step)] == b[i];
            inside += !edge;
        }
    }
    fmt::print("{} of {} pixels differ, {} of them not at an edge\n", differ, pixels, inside);
    EXPECT_LT(differ, pixels / 200);
    EXPECT_LE(inside, pixels / 10000); // where elements are smaller than a pixel
}

// HC-7: a screen that hides half of what a patch sees of another: by subdivision the mean of all-or-nothing is right.
TEST_F(Hemicube, HalfOccluded) {
    PatchMesh mesh;
    const AddedGrid from = add_grid(mesh, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 16, 16, 1});
    const AddedGrid to = add_grid(mesh, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 4, 4, 4});
    // A wall across the middle from one to the other: each point sees the half on its side only.
    const AddedGrid left = add_grid(mesh, {{0.5, 0, 0}, {0, 0, 1}, {0, 1, 0}, 2, 2, 2});
    const AddedGrid right = add_grid(mesh, {{0.5, 0, 0}, {0, 1, 0}, {0, 0, 1}, 2, 2, 2});
    for (std::uint32_t i = 0; i < left.elements; ++i) { // the two sides of one wall: corners are those of the left
        const std::uint32_t a = left.first_element + i, b = right.first_element + i / 2 + i % 2 * 2;
        mesh.elements[a].behind = b, mesh.elements[b].behind = a;
    }
    const double f = between(mesh, from, to, {.resolution = 128, .batch = 16}), half = parallel_rectangles(0.5, 1, 1);
    EXPECT_NEAR(f / half, 1, 0.02);
    // Each side of the wall gets what the half of the shooter on its side sends: as two that stand on each other's edge.
    const double wall = perpendicular_rectangles(1, 0.5, 1) / 2;
    EXPECT_NEAR(between(mesh, from, left, {.resolution = 128, .batch = 16}) / wall, 1, 0.02);
    EXPECT_NEAR(between(mesh, from, right, {.resolution = 128, .batch = 16}) / wall, 1, 0.02);
}

// HC-9: a float would make 2^24 of 2^24 + 1. As many elements do not fit a test: only their numbers are drawn.
TEST_F(Hemicube, ElementNumbersAreWhole) {
    constexpr std::uint32_t kMany = (1u << 24) + 1;
    const PatchMesh mesh = closed_box(2, 2);
    HemicubeMesh made = hemicube_mesh(mesh);
    for (FaceVertex& v : made.vertices) v.sides += kMany;
    HemicubeState state{.device = device(), .request = {.resolution = 8, .batch = 1, .way = HemicubeWay::raster}};
    const gpu_layout::Shooter& s = made.shooters[0];
    const gpu_layout::HemicubeView view{s.center, 0, s.tangent, 0, glm::cross(s.normal, s.tangent), 0, s.normal, s.radius, s.area, 0, 0, 0};
    state.views = hemicube_table(state, "views", std::as_bytes(std::span(&view, 1)), FETCH_HEMICUBE_VIEWS);
    state.items = empty_hemicube_table(state, "items", state.face_items() * 4, FETCH_HEMICUBE_ITEMS);
    state.faces = make_faces(state, made);
    gpu::Recorder recorder(device());
    record_faces(recorder, state);
    recorder.submit_and_wait();
    std::vector<std::uint32_t> seen(mesh.elements.size());
    for (std::uint32_t item : gpu::download_all<std::uint32_t>(device(), state.items)) {
        ASSERT_GE(item, kMany);
        ASSERT_LT(item, kMany + seen.size());
        ++seen[item - kMany];
    }
    EXPECT_THAT(std::span(seen).first(4), testing::Each(0u));
    EXPECT_THAT(std::span(seen).subspan(4), testing::Each(testing::Gt(0u))); // odd and even numbers
}

// The same rows, whatever else is in the batch and whatever was recorded before, to the bit; chosen on the device's side.
TEST_F(Hemicube, RowsAreTheSameAgain) {
    const PatchMesh mesh = closed_box(8, 2);
    for (HemicubeWay way : {HemicubeWay::rays, HemicubeWay::raster}) {
        const HemicubeRequest request{.resolution = 32, .batch = 7, .way = way, .correct_near = true};
        Hemicubes cubes(device(), mesh, request);
        const auto once = rows_of(cubes, mesh, request, {3, 14, 15, 92, 65, 35, 89});
        const auto again = rows_of(cubes, mesh, request, {89, 35, 65});
        EXPECT_EQ(again[0], once[6]);
        EXPECT_EQ(again[1], once[5]);
        EXPECT_EQ(again[2], once[4]);
    }
}

} // namespace lightbench
