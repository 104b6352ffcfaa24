// Snell, plates, prisms, lenses, the critical angle (S16, RF rows): each pixel against a closed form.
#include "images/ray_screen.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lightbench::testing {
namespace {

using glm::dvec3;

// Down through flat layers of indices n[i] and thicknesses h[i]: n sin is the same in all.
std::optional<dvec3> through_layers(const dvec3& eye, const dvec3& d, const std::vector<std::pair<double, double>>& layers) {
    const double flat = std::hypot(d.x, d.z), sine = layers.front().first * flat;
    double across = 0;
    for (const auto& [n, h] : layers) {
        if (sine >= n) return std::nullopt;
        across += h * std::tan(std::asin(sine / n));
    }
    return kFloor.meet({eye.x + across * d.x / flat, 1, eye.z + across * d.z / flat}, {0, -1, 0});
}

// S16's own example: 30 degrees in air become 19.47 in glass, which bends by 10.53.
TEST(RayOptics, SnellBendsThirtyDegreesByTenAndAHalf) {
    const double h = 2, depth = 3;
    const dvec3 eye(-h * std::tan(30 * kDegree), depth + h, 0);
    Scene scene = screen_scene(kFloor, eye, {0, depth, 0}, 20 * kDegree);
    add(scene, slab(-1, depth), glass(1.5f));
    expect_landing(
        scene, kFloor,
        [&](const dvec3& d) {
            return through_layers(eye, d, {{1, h}, {1.5, depth}});
        },
        1e-5);

    const Rendered r = render_scene(scene, ray_request({47, 35}));
    const auto red = [&](double bend) { return kFloor.radiance({depth * std::tan(30 * kDegree - bend), 0, 0}).x; };
    const double bend = 10.52877937 * kDegree, slope = (red(bend + 1e-6) - red(bend - 1e-6)) / 2e-6;
    EXPECT_LT(std::abs(pixel(*r.output.radiance, 23, 17).x - red(bend)), 1e-5 * std::abs(slope)) << "10 microradians";
}

// RF-4: parallel, and shifted by d sin a (1 - cos a / sqrt(n^2 - sin^2 a)).
TEST(RayOptics, AParallelPlateShiftsTheRay) {
    const dvec3 eye(-4, 6, 0.5);
    const double thickness = 1;
    Scene scene = screen_scene(kFloor, eye, {1, 0, 0}, 30 * kDegree);
    add(scene, slab(2, 2 + thickness), glass(1.5f));
    expect_landing(
        scene, kFloor,
        [&](const dvec3& d) {
            const double sine = std::hypot(d.x, d.z), cosine = -d.y;
            const double shift = thickness * sine * (1 - cosine / std::sqrt(1.5 * 1.5 - sine * sine));
            const dvec3 flat = glm::normalize(dvec3(d.x, 0, d.z)), back = glm::normalize(-cosine * flat - dvec3(0, sine, 0));
            return kFloor.meet(eye + shift * back, d);
        },
        1e-5);
}

// RF-6: ten plates apart, and two that overlap: what was entered last counts where both are.
TEST(RayOptics, StacksOfPlatesAndOverlappingPlates) {
    const dvec3 eye(-3, 8, 0.5);
    Scene stack = screen_scene(kFloor, eye, {1, 0, 0}, 25 * kDegree);
    std::vector<std::pair<double, double>> layers{{1, 8 - 10 * 0.25}};
    for (int i = 0; i < 5; ++i) {
        const float n = 1.1f + 0.2f * float(i);
        add(stack, slab(2 + 0.5 * i, 2.25 + 0.5 * i), glass(n));
        layers.emplace_back(double(n), 0.25);
    }
    layers.front().second = 8 - 5 * 0.25;
    expect_landing(
        stack, kFloor, [&](const dvec3& d) { return through_layers(eye, d, layers); }, 2e-5);

    Scene two = screen_scene(kFloor, eye, {1, 0, 0}, 25 * kDegree);
    add(two, slab(2.5, 4.5), glass(1.5f)), add(two, slab(2, 3.5), glass(1.25f));
    expect_landing(
        two, kFloor,
        [&](const dvec3& d) {
            return through_layers(eye, d, {{1, 5.5}, {1.5, 1}, {1.25, 1.5}});
        },
        2e-5);
}

// RF-6: media that touch are as one interface where they overlap a little; by how much does not matter, but that rounding leaves it.
TEST(RayOptics, PlatesThatTouchOverlap) {
    const dvec3 eye(-3, 8, 0.5);
    const double overlap = 0x1p-10;
    for (const bool upper : {false, true}) { // the one that is made larger
        Scene scene = screen_scene(kFloor, eye, {1, 0, 0}, 25 * kDegree);
        const double up = upper ? 0 : overlap, down = upper ? overlap : 0;
        add(scene, slab(2, 3 + up), glass(1.25f)), add(scene, slab(3 - down, 4), glass(1.5f));
        expect_landing(
            scene, kFloor,
            [&](const dvec3& d) {
                return through_layers(eye, d, {{1, 6}, {1.5, 1 - up}, {1.25, 1 + up}});
            },
            2e-5);
    }
}

// What stands on a floor shows it, through its upper face alone, and light comes by the same: kt twice.
TEST(RayOptics, AGlassBlockStandsOnAFloor) {
    const dvec3 eye(-3, 8, 0.5), kt(0.875, 0.5, 0.25);
    Scene scene = screen_scene(kFloor, eye, {1, 0, 0}, 25 * kDegree);
    Material tinted = glass(1.5f);
    tinted.transmission = glm::vec3(kt);
    add(scene, slab(0, 1), tinted);
    expect_landing(
        scene, kFloor,
        [&](const dvec3& d) {
            return through_layers(eye, d, {{1, 7}, {1.5, 1}});
        },
        2e-5, kt * kt);
}

// Straight down, Fresnel's split leaves 1 - (0.5 / 2.5)^2 of what is seen; shadows know no split.
TEST(RayOptics, StraightDownThroughAGlassBlock) {
    const dvec3 eye(0.25, 6, 0.125), kt(0.875, 0.5, 0.25);
    Scene scene = screen_scene(kFloor, eye, {0.25, 0, 0.125}, 5 * kDegree);
    Material tinted = glass(1.5f);
    tinted.transmission = glm::vec3(kt), tinted.fresnel = true;
    add(scene, Box{{-1.3, 0, -0.7}, {1.1, 0.9, 0.8}}, tinted);
    const Rendered r = render_scene(scene, ray_request({5, 5}));
    const dvec3 want = 0.96 * kt * kt * kFloor.radiance({0.25, 0, 0.125}), got = pixel(*r.output.radiance, 2, 2);
    EXPECT_LT(glm::length(got - want), 1e-5 * glm::length(want)) << got.x << ' ' << got.y << ' ' << got.z;
}

// What a surface under or upon glass sends on starts so far above it that the glass is passed once (leave_what_touches of shade.comp): here
// by 1.5e-3, four slacks of a scene 40 wide. Where such a ray lands is off by about as much, and the screen changes by 1/1.5 of itself a
// unit at most, by a tenth on the whole.
constexpr double kTouched = 1.5e-4;

// A mirror under the glass: its rays are in the glass from the first, and leave it once.
TEST(RayOptics, AGlassBlockStandsOnAMirror) {
    const Screen ceiling{{0, 9, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}, 30};
    const dvec3 eye(-3, 8, 0.5);
    Scene scene = screen_scene(ceiling, eye, {1, 0, 0}, 25 * kDegree);
    add(scene, Polygon{{{-20, 0, 20}, {20, 0, 20}, {20, 0, -20}, {-20, 0, -20}}, {}}, mirror());
    add(scene, slab(0, 1), glass(1.5f));
    expect_landing(
        scene, ceiling,
        [&](const dvec3& d) -> std::optional<dvec3> {
            auto p = through_layers(eye, d, {{1, 7 + 8}, {1.5, 2}});
            if (p) p->y = 9;
            return p;
        },
        kTouched);
}

// A label that is half clear, on the upper face or on the lower one: passed once.
TEST(RayOptics, ALabelOnGlassIsPassedOnce) {
    const dvec3 eye(-3, 8, 0.5);
    for (const double height : {2.0, 3.0}) {
        Scene scene = screen_scene(kFloor, eye, {1, 0, 0}, 25 * kDegree);
        Material label;
        label.diffuse = glm::vec3(0), label.opacity = glm::vec3(0.5f);
        add(scene, Polygon{{{-20, height, 20}, {20, height, 20}, {20, height, -20}, {-20, height, -20}}, {}}, label);
        add(scene, slab(2, 3), glass(1.5f));
        expect_landing(
            scene, kFloor,
            [&](const dvec3& d) {
                return through_layers(eye, d, {{1, 7}, {1.5, 1}});
            },
            kTouched, dvec3(0.5));
    }
}

// RF-6: the eye is in the glass.
TEST(RayOptics, TheCameraMayStandInGlass) {
    const dvec3 eye(-2, 4, 0.5);
    Scene scene = screen_scene(kFloor, eye, {0, 0, 0}, 25 * kDegree);
    add(scene, slab(3, 5), glass(1.5f));
    expect_landing(
        scene, kFloor,
        [&](const dvec3& d) {
            return through_layers(eye, d, {{1.5, 1}, {1, 3}});
        },
        1e-5);
}

// RF-6: the eye is in both of two, which no ray can tell it: the media that the eye is in are handed to the eye rays.
TEST(RayOptics, TheCameraMayStandInTwoGlasses) {
    const dvec3 eye(-2, 4, 0.5);
    Scene scene = screen_scene(kFloor, eye, {0, 0, 0}, 25 * kDegree);
    add(scene, slab(3, 5), glass(1.5f)), add(scene, slab(2, 5.5), glass(1.25f));
    expect_landing(
        scene, kFloor,
        [&](const dvec3& d) {
            return through_layers(eye, d, {{1.5, 1}, {1.25, 1}, {1, 2}});
        },
        1e-5);
}

// RF-2: from inside, what is seen changes at the critical angle, where sin = 1 / 1.5.
TEST(RayOptics, TotalReflectionBeginsAtTheCriticalAngle) {
    Scene scene;
    Camera camera;
    camera.position = {0, -2, 0}, camera.target = {std::tan(std::asin(1 / 1.5)) * 2, 0, 0}, camera.fov = 30 * kDegree;
    scene.cameras = {camera};
    scene.environment.background = {0, 0, 1};
    add(scene, Box{{-50, -50, -50}, {50, 0, 50}}, glass(1.5f));
    Material red;
    red.diffuse = glm::vec3(0), red.emission = {1, 0, 0};
    add(scene, Polygon{{{-40, -2.5, 40}, {40, -2.5, 40}, {40, -2.5, -40}, {-40, -2.5, -40}}, {}}, red);
    const Rendered r = render_scene(scene, ray_request({64, 48}));
    unsigned total = 0, through = 0;
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            const dvec3 d = r.view.direction_through({x + 0.5, y + 0.5});
            const double sine = std::hypot(d.x, d.z);
            if (d.y <= 0 || std::abs(sine * 1.5 - 1) < 1e-5) continue;
            const dvec3 want = sine * 1.5 > 1 ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
            ++(sine * 1.5 > 1 ? total : through);
            ASSERT_EQ(pixel(*r.output.radiance, x, y), want) << x << ' ' << y << " sine " << sine;
        }
    EXPECT_GT(total, 500u);
    EXPECT_GT(through, 500u);
}

// A 60 degree prism of index 1.5 in its principal section: deviation i1 + i2 - A, least 37.18 degrees.
TEST(RayOptics, APrismDeviates) {
    const Screen wall{{6, -4, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 10};
    const double tall = std::sqrt(3.0) / 2; // sides of length 1, tip up
    const dvec3 in_normal(-std::cos(30 * kDegree), std::sin(30 * kDegree), 0), on_left(-0.25, tall / 2, 0);
    // At least deviation the ray goes level through the prism: 48.59 degrees from the normal.
    const double i0 = std::asin(1.5 * std::sin(30 * kDegree)), slope = i0 - 30 * kDegree;
    const dvec3 eye = on_left - 3.0 * dvec3(std::cos(slope), std::sin(slope), 0);
    Scene scene = screen_scene(wall, eye, on_left, 3 * kDegree);
    Mesh mesh;
    mesh.positions = {{-0.5f, 0, 2}, {0.5f, 0, 2}, {0, float(tall), 2}, {-0.5f, 0, -2}, {0.5f, 0, -2}, {0, float(tall), -2}};
    mesh.corners = {0, 1, 2, 5, 4, 3, 0, 2, 5, 3, 2, 1, 4, 5, 1, 0, 3, 4};
    mesh.face_starts = {0, 3, 6, 10, 14, 18};
    scene.meshes = {mesh};
    add(scene, MeshUse{0}, glass(1.5f));
    const Rendered r = render_scene(scene, ray_request({47, 35}));
    const dvec3 d = r.view.direction_through({23.5, 17.5});
    const double i1 = std::acos(-glm::dot(d, in_normal)), r1 = std::asin(std::sin(i1) / 1.5),
                 i2 = std::asin(1.5 * std::sin(60 * kDegree - r1));
    EXPECT_NEAR((i1 + i2 - 60 * kDegree) / kDegree, 37.1808, 1e-3);
    const auto at = [&](double deviation) {
        const double way = slope - deviation; // the way out, and where it leaves: as high as it came in
        return wall.radiance(*wall.meet({0.25, tall / 2, 0}, {std::cos(way), std::sin(way), 0}));
    };
    const dvec3 want = at(i1 + i2 - 60 * kDegree), got = pixel(*r.output.radiance, 23, 17);
    EXPECT_LT(glm::length(got - want), 2e-5 * glm::length(want)) << got.y << " for " << want.y;
    EXPECT_GT(glm::length(at(37 * kDegree) - want), 1e-3 * glm::length(want)) << "the control: it would be seen";
}

// RF-5: a ray at the distance b from the center keeps it and turns by 2 (i - r), sin i = b / R. All pixels, and the paraxial focus.
void ball_lens(double distance, double fov, double tolerance) {
    const Screen wall{{0, 0, -6}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    const dvec3 eye(0, 0, distance);
    Scene scene = screen_scene(wall, eye, {0, 0, 0}, fov);
    add(scene, Sphere{{0, 0, 0}, 1}, glass(1.5f));
    expect_landing(
        scene, wall,
        [&](const dvec3& d) -> std::optional<dvec3> {
            const double u = std::atan2(std::hypot(d.x, d.y), -d.z), b = distance * std::sin(u);
            if (b > 0.95) return std::nullopt;
            const dvec3 side = b == 0 ? dvec3(1, 0, 0) : glm::normalize(dvec3(d.x, d.y, 0));
            const double way = u - 2 * (std::asin(b) - std::asin(b / 1.5));
            return wall.meet(b * (std::cos(way) * side + dvec3(0, 0, std::sin(way))),
                             {std::sin(way) * side.x, std::sin(way) * side.y, -std::cos(way)});
        },
        tolerance);
}

TEST(RayOptics, ABallIsALens) {
    ball_lens(3, 20 * kDegree, 5e-5);
}

// From the focus n R / (2 (n - 1)) = 1.5 R a ball sends parallel rays on: 1/100 R off the axis to 1e-4.
TEST(RayOptics, ABallHasItsFocusWhereGaussHasIt) {
    ball_lens(1.5, 2 * std::atan(0.01 / 1.5), 1e-5);
    const double b = 0.01, u = std::asin(b / 1.5);
    EXPECT_LT(std::abs(u - 2 * (std::asin(b) - std::asin(b / 1.5))), 1e-4 * u) << "the closed form itself";
}

// kt colors what is seen through, once a surface.
TEST(RayOptics, TransmissionIsColored) {
    const dvec3 eye(0.5, 6, 1);
    Scene scene = screen_scene(kFloor, eye, {0, 0, 0}, 30 * kDegree);
    Material tinted = glass(1.5f);
    tinted.transmission = {0.875f, 0.5f, 0.25f};
    add(scene, slab(2, 3), tinted);
    const dvec3 kt(tinted.transmission);
    expect_landing(
        scene, kFloor,
        [&](const dvec3& d) {
            return through_layers(eye, d, {{1, 5}, {1.5, 1}});
        },
        1e-5, kt * kt);
}

} // namespace
} // namespace lightbench::testing
