// Mirrors without a map (S12): what an object shows of the scene around it, against the closed form of a room of colored walls, against
// rays, and where it must not matter how the picture is asked for.
#include "images/rendering.h"
#include "shared/effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lightbench::testing {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kWall = 10; // metres from the room's middle

// Of a wall's quarter: face in the order +X -X +Y -Y +Z -Z, and the signs of the two other coordinates, in their order.
vec3 color_of(int face, bool first, bool second) {
    return {0.1f + 0.15f * float(face), first ? 0.9f : 0.3f, second ? 0.8f : 0.2f};
}

// What is seen from `p` along `d`.
struct Seen {
    vec3 color{0};
    bool near_edge = false; // of a quarter: pixels there are mixed
};
Seen room_seen(const dvec3& p, const dvec3& d) {
    int axis = 0;
    double nearest = 1e300;
    for (int i = 0; i < 3; ++i)
        if (d[i] != 0 && ((d[i] > 0 ? kWall : -kWall) - p[i]) / d[i] < nearest)
            axis = i, nearest = ((d[i] > 0 ? kWall : -kWall) - p[i]) / d[i];
    const dvec3 at = p + nearest * d;
    const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    const auto edge = [](double x) { return std::abs(x) < 2 || std::abs(x) > kWall - 2; };
    return {color_of(2 * axis + (d[axis] < 0), at[u] > 0, at[v] > 0), edge(at[u]) || edge(at[v])};
}

void add_quarter(Scene& scene, int face, bool first, bool second) {
    const int axis = face / 2, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
    const double us = first ? kWall : -kWall, vs = second ? kWall : -kWall;
    Polygon quarter;
    for (const auto& [a, b] : {std::pair{0.0, 0.0}, std::pair{us, 0.0}, std::pair{us, vs}, std::pair{0.0, vs}}) {
        dvec3 p(0);
        p[axis] = face % 2 ? -kWall : kWall, p[u] = a, p[v] = b;
        quarter.points.push_back(p);
    }
    Material glow;
    glow.diffuse = vec3(0), glow.emission = color_of(face, first, second);
    scene.materials.push_back(glow);
    Object object;
    object.shape = quarter, object.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    scene.objects.push_back(object);
}

// Mirroring balls in the room; the first material is theirs.
Scene room(const std::vector<Sphere>& balls, const dvec3& eye) {
    Scene scene;
    Camera camera;
    camera.position = eye, camera.target = balls.front().center, camera.fov = 0.5;
    scene.cameras = {camera};
    Material chrome;
    chrome.diffuse = vec3(0), chrome.environment = 1, chrome.reflection = vec3(1);
    scene.materials = {chrome};
    scene.lights = {point_light({0, 0, 0}, vec3(0))}; // none at all would be a headlight
    for (const Sphere& ball : balls) scene.objects.push_back({ball});
    for (int face = 0; face < 6; ++face)
        for (int quarter = 0; quarter < 4; ++quarter) add_quarter(scene, face, quarter & 1, quarter & 2);
    return scene;
}

struct Met {
    dvec3 normal{0}, mirrored{0};
    double facing = 0; // cosine to the viewer
};

std::optional<Met> meet(const Sphere& ball, const View& view, unsigned x, unsigned y) {
    const dvec3 d = view.direction_through({x + 0.5, y + 0.5}), from = view.eye - ball.center;
    const double b = glm::dot(from, d), disc = b * b - glm::dot(from, from) + ball.radius * ball.radius;
    if (disc < 0) return std::nullopt;
    const dvec3 n = (from + (-b - std::sqrt(disc)) * d) / ball.radius;
    return Met{n, glm::reflect(d, n), -glm::dot(n, d)};
}

// A pixel of these pictures spans up to 1.25 m of a wall's 20 (a texel of the third level): 2 m from an edge it is of one color.
// Compares the pixels of a ball that see the inner part of a wall's quarter, not at the rim, where a pixel spans much of the room.
// Returns how many there were, by face.
std::array<int, 6> compare_ball(const Rendered& r, const Scene& scene, std::size_t ball, double tolerance) {
    std::array<int, 6> counted{};
    const Sphere& sphere = std::get<Sphere>(scene.objects[ball].shape);
    for (unsigned y = 0; y < r.view.size.y; ++y)
        for (unsigned x = 0; x < r.view.size.x; ++x) {
            const auto met = meet(sphere, r.view, x, y);
            if (!met || met->facing < 0.6) continue;
            const Seen seen = room_seen(sphere.center, met->mirrored);
            bool hidden = false;
            for (std::size_t other = 0; other < scene.objects.size(); ++other) {
                const auto* s = std::get_if<Sphere>(&scene.objects[other].shape);
                if (s == nullptr || other == ball) continue;
                const dvec3 to = s->center - sphere.center;
                hidden = hidden || glm::dot(met->mirrored, to) > glm::length(to) * std::cos(3 * s->radius / glm::length(to));
            }
            if (seen.near_edge || hidden) continue;
            const int face = static_cast<int>(std::lround((seen.color.x - 0.1f) / 0.15f));
            ++counted[static_cast<std::size_t>(face)];
            EXPECT_LT(glm::length(pixel(*r.output.radiance, x, y) - dvec3(seen.color)), tolerance) << x << ' ' << y << " face " << face;
        }
    return counted;
}

// Each quarter of each wall is where the mirror direction says, from four sides: no face is turned, mirrored or taken for another.
TEST(EnvironmentCube, ABallShowsEachWallWhereTheMirrorDirectionMeetsIt) {
    std::array<int, 6> all{};
    for (const dvec3& way : {dvec3(1, 0.6, 0.8), dvec3(-1, -0.7, 0.6), dvec3(0.7, -0.6, -1), dvec3(-0.6, 1, -0.8)}) {
        const Scene scene = room({{{0, 0, 0}, 0.2}}, glm::normalize(way));
        const Rendered r = render_scene(scene, radiance_request(Shading::phong, {160, 160}));
        EXPECT_TRUE(r.plan.effects & EFFECT_RENDERED_CUBE && r.plan.effects & EFFECT_SIX_FACES && r.plan.runs("environment-cube"));
        ASSERT_EQ(r.plan.cubes.cubes.size(), 1u);
        EXPECT_EQ(r.output.non_finite, 0u);
        // Halves keep 11 bits. The faceted ball's normals are off by far less than an edge's margin.
        const auto counted = compare_ball(r, scene, 0, 2e-3);
        for (std::size_t i = 0; i < 6; ++i) all[i] += counted[i];
    }
    for (std::size_t i = 0; i < 6; ++i) EXPECT_GT(all[i], 400) << i;
}

// Each object has its own middle: two balls far apart see two different rooms.
TEST(EnvironmentCube, EachObjectSeesTheRoomFromItsOwnMiddle) {
    Scene scene = room({{{-4, 1, 2}, 0.2}, {{-3.4, 1, 2}, 0.15}, {{5, -3, -4}, 0.2}}, {-3.6, 1.4, 3.2});
    scene.cameras[0].fov = 1.2;
    const Rendered r = render_scene(scene, radiance_request(Shading::phong, {480, 480}));
    EXPECT_EQ(r.plan.cubes.cubes.size(), 3u);
    int pixels = 0;
    for (std::size_t ball = 0; ball < 2; ++ball)
        for (const int n : compare_ball(r, scene, ball, 2e-3)) pixels += n;
    EXPECT_GT(pixels, 1500);
}

// The turntable's camera, and a picture's part: the cubes do not depend on either.
TEST(EnvironmentCube, FramesOfTheTurntableAndCropsAgree) {
    const Scene scene = room({{{0, 0, 0}, 0.2}}, {0.5, 0.6, 0.9});
    Request request = radiance_request(Shading::phong, {192, 192});
    const Rendered whole = render_scene(scene, request);
    request.crop = Rect{{20, 31}, {40, 22}};
    const Rendered part = render_scene(scene, request);
    for (unsigned y = 0; y < 22; ++y)
        for (unsigned x = 0; x < 40; ++x)
            ASSERT_EQ(pixel(*part.output.radiance, x, y), pixel(*whole.output.radiance, x + 20, y + 31)) << x << ' ' << y;
    request.crop.reset();
    for (const int frame : {37, 120}) {
        request.frame = frame;
        const Rendered turned = render_scene(scene, request);
        int pixels = 0;
        for (const int n : compare_ball(turned, scene, 0, 2e-3)) pixels += n;
        EXPECT_GT(pixels, 700) << frame;
        EXPECT_EQ(turned.output.radiance->rgba == whole.output.radiance->rgba, frame == 120);
    }
}

TEST(EnvironmentCube, TwoRunsAreEqual) {
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        const Scene scene = room({{{0, 0, 0}, 0.2}}, {0.5, 0.6, 0.9});
        const Rendered a = render_scene(scene, radiance_request(shading)), b = render_scene(scene, radiance_request(shading));
        EXPECT_EQ(a.output.radiance->rgba, b.output.radiance->rgba);
        EXPECT_EQ(a.output.non_finite, 0u);
    }
}

// Walls of one color: the ball has that color everywhere, wherever the model is evaluated, tinted by its reflection.
TEST(EnvironmentCube, InARoomOfOneColorEveryShadingShowsIt) {
    Scene scene = room({{{1, 0, 2}, 0.2}}, {1.4, 0.6, 2.9});
    for (std::size_t i = 1; i < scene.materials.size(); ++i) scene.materials[i].emission = {0.5f, 0.25f, 2};
    scene.materials[0].environment = 0.5f, scene.materials[0].reflection = vec3(1, 0.5f, 0.25f);
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        const Rendered r = render_scene(scene, radiance_request(shading));
        const dvec3 on_ball = pixel(*r.output.radiance, 32, 24), expected(0.25, 0.0625, 0.25);
        EXPECT_LT(glm::length(on_ball - expected), 1e-5) << static_cast<int>(shading);
    }
}

// The same scene by rays, which start from the ball's surface, not from its middle: apart by the ball's radius over the walls' distance, so
// that two percent of a picture of a ball of 0.2 m between walls at 10 m differ, along edges.
TEST(EnvironmentCube, FarWallsAgreeWithRays) {
    const Scene scene = room({{{0, 0, 0}, 0.2}}, {0.5, 0.6, 0.9});
    Request request = radiance_request(Shading::phong, {128, 128});
    const Rendered drawn = render_scene(scene, request);
    request.method = Method::raytrace;
    const Rendered traced = render_scene(scene, request);
    EXPECT_FALSE(traced.plan.effects & EFFECT_RENDERED_CUBE);
    double difference = 0, sum = 0;
    const Sphere& ball = std::get<Sphere>(scene.objects[0].shape);
    for (unsigned y = 0; y < 128; ++y)
        for (unsigned x = 0; x < 128; ++x)
            if (const auto met = meet(ball, drawn.view, x, y); met && met->facing > 0.2) {
                const dvec3 a = pixel(*drawn.output.radiance, x, y), b = pixel(*traced.output.radiance, x, y);
                difference += glm::length(a - b), sum += glm::length(b);
            }
    RecordProperty("percent", std::to_string(100 * difference / sum));
    EXPECT_LT(difference, 0.04 * sum);
    EXPECT_GT(sum, 1000);
}

// Ten balls, eight cubes; the two farthest share the nearest one's. Surfaces are no more than cubes.
TEST(EnvironmentCube, TheFarthestShareTheCubesOfTheOthers) {
    std::vector<Sphere> balls;
    for (int i = 0; i < 10; ++i) balls.push_back({{0.5 * i - 2, 0, -0.4 * i}, 0.2});
    const Scene scene = room(balls, {-2, 1, 3});
    const Rendered r = render_scene(scene, radiance_request(Shading::phong));
    EXPECT_EQ(r.plan.cubes.cubes.size(), 8u);
    EXPECT_EQ(r.plan.cubes.of_object[9], 7u);
    EXPECT_EQ(r.geometry.surfaces.size(), 8u + 24u);
    EXPECT_EQ(r.output.non_finite, 0u);
    const auto line = std::ranges::find(r.plan.fallbacks, "environment: rendered", &Line::name);
    ASSERT_NE(line, r.plan.fallbacks.end());
    EXPECT_NE(line->reason.find("10 objects mirror"), std::string::npos);
}

// One bounce: a mirror in a mirror is drawn as its material is without.
TEST(EnvironmentCube, AMirrorInAMirrorShowsItsOwnMaterial) {
    Scene scene = room({{{0, 0, 0}, 0.2}, {{2, 0, 0}, 1}}, {0.9, 0, 0.9});
    scene.materials[0].emission = {0, 0, 4};
    const Rendered r = render_scene(scene, radiance_request(Shading::phong, {64, 64}));
    // The mirror direction of the ball's point at (1, 0, 1) / sqrt(2), which faces the eye, turned by the pixel that looks along +x.
    double blue = 0;
    for (unsigned y = 0; y < 64; ++y)
        for (unsigned x = 0; x < 64; ++x)
            if (const auto met = meet(std::get<Sphere>(scene.objects[0].shape), r.view, x, y); met && met->mirrored.x > 0.97) {
                blue = pixel(*r.output.radiance, x, y).z;
                EXPECT_NEAR(blue, 8, 0.01) << x << ' ' << y; // its own glow, and the other's
            }
    EXPECT_GT(blue, 0);
}

// Terms add up to the image.
TEST(EnvironmentCube, TheReflectedTermIsALayer) {
    Scene scene = room({{{0, 0, 0}, 0.2}}, {0.5, 0.6, 0.9});
    Request request = radiance_request(Shading::phong);
    request.terms = true;
    const Rendered r = render_scene(scene, request);
    const auto find = [&](std::string_view name) { return std::ranges::find(r.output.layers, name, &Layer::name); };
    ASSERT_NE(find("reflected"), r.output.layers.end());
    for (unsigned y = 0; y < 48; ++y)
        for (unsigned x = 0; x < 64; ++x) {
            const dvec3 sum = pixel(find("reflected")->image, x, y) + pixel(find("emission")->image, x, y);
            ASSERT_LT(glm::length(sum - pixel(*r.output.radiance, x, y)), 1e-5) << x << ' ' << y;
        }
}

} // namespace
} // namespace lightbench::testing
