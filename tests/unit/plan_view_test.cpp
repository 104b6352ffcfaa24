// The camera's matrices: orthonormal for every direction, pixel rays true to the bound of CA-2, invariant under scale (SC-1).
#include "plan/complete.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace lightbench {
namespace {

using Long = long double;
struct LongVec {
    Long x, y, z;
};

constexpr double kU = 0x1p-24; // unit roundoff of float

// The oracle: the ray through a point of the image in the camera's own axes, from the definition, in 64 bits of mantissa.
LongVec oracle_ray(double fov, glm::uvec2 size, glm::dvec2 pixel) {
    const Long half = std::tan(Long(fov) / 2);
    const Long x = (2 * Long(pixel.x) / size.x - 1) * half * size.x / size.y, y = (1 - 2 * Long(pixel.y) / size.y) * half;
    const Long length = std::sqrt(x * x + y * y + 1);
    return {x / length, y / length, -1 / length};
}

Long angle_between(const LongVec& a, const LongVec& b) {
    const LongVec c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return std::atan2(std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z), a.x * b.x + a.y * b.y + a.z * b.z);
}

// A scene with one camera; its lights and objects do not matter here.
View view_of(const Camera& camera, glm::uvec2 size, std::vector<Line>* notes = nullptr) {
    Scene scene;
    scene.materials.emplace_back();
    scene.objects.push_back({Sphere{}});
    scene.cameras.push_back(camera);
    Request request;
    request.size = size;
    const CompleteResult result = complete(scene, request);
    EXPECT_TRUE(result.completed) << (result.problems.empty() ? "" : to_string(result.problems[0]));
    if (notes) *notes = result.completed->notes;
    return result.completed->view;
}

Camera looking(glm::dvec3 from, glm::dvec3 to, glm::dvec3 up, double fov = 0.8) {
    Camera camera;
    camera.position = from, camera.target = to, camera.up = up, camera.fov = fov;
    return camera;
}

double orthonormality_error(const glm::dmat3& m) {
    const glm::dmat3 e = m * glm::transpose(m) - glm::dmat3(1);
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) worst = std::max(worst, std::abs(e[i][j]));
    return worst;
}

// CA-1 asks for 4 u of float; the axes are double. A normalised vector is within 3 u of unit length, which counts twice in a square, and
// the third axis is the product of two such: 12 u and the test's own roundings, with u = 2^-53.
TEST(PlanView, AxesAreOrthonormalHoweverUpIsGiven) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> exponent(-18, 0);
    const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 eye = vector() * 10.0, direction = vector();
        const glm::dvec3 up = direction + vector() * std::pow(10, exponent(random)); // often all but parallel
        const glm::dmat4 view = view_of(looking(eye, eye + direction, up), {64, 64}).view_from_world;
        ASSERT_LE(orthonormality_error(glm::dmat3(view)), 16 * 0x1p-53) << i;
        ASSERT_GT(glm::determinant(glm::dmat3(view)), 0.9);      // a rotation, no mirror
        ASSERT_LT((view * glm::dvec4(eye + direction, 1)).z, 0); // the target lies ahead
    }
}

TEST(PlanView, UpParallelToTheViewIsReplacedAndSaid) {
    std::vector<Line> notes;
    const View down = view_of(looking({0, 5, 0}, {0, 0, 0}, {0, 1, 0}), {64, 64}, &notes);
    ASSERT_FALSE(notes.empty());
    EXPECT_EQ(notes[0].name, "camera up");
    const glm::dvec3 up = glm::transpose(glm::dmat3(down.view_from_world))[1];
    EXPECT_NEAR(glm::dot(up, glm::dvec3(0, 0, -1)), 1, 1e-15); // north is up, as on a map
    view_of(looking({0, 5, 1}, {0, 0, 0}, {0, 1, 0}), {64, 64}, &notes);
    for (const Line& line : notes) EXPECT_NE(line.name, "camera up");
}

// CA-2: widths to 16 384, aspects to 1e4, fields of view from 1e-3 to 179.9 degrees. The ray that a pixel stands for is what the float
// matrix maps there: the oracle's ray goes through the matrix, and where it lands is compared with where it should.
TEST(PlanView, PixelRaysWithinTheBound) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    const glm::uvec2 sizes[] = {{1, 1}, {1280, 720}, {16384, 2}, {16384, 16384}, {2, 16384}};
    for (double degrees : {1e-3, 0.1, 1.0, 45.0, 90.0, 170.0, 179.9}) {
        for (glm::uvec2 size : sizes) {
            const double fov = degrees * 3.14159265358979323846 / 180;
            const View view = view_of(looking({1, 2, 3}, {-4, 0.5, 2}, {0.1, 1, 0.2}, fov), size);
            for (int i = 0; i < 2000; ++i) {
                const glm::dvec2 pixel = {unit(random) * size.x, unit(random) * size.y};
                const LongVec expected = oracle_ray(fov, size, pixel);
                const glm::dvec3 world = view.direction_through(pixel);
                const glm::dvec3 seen = glm::dmat3(view.view_from_world) * world;
                ASSERT_LE(angle_between({seen.x, seen.y, seen.z}, expected), 1e-7L * fov + 2 * kU) << degrees;
            }
        }
    }
}

// The float matrix itself: the direction of a pixel, projected, lands on that pixel up to the angle that the bound allows.
TEST(PlanView, TheFloatMatrixProjectsRaysToTheirPixels) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (double degrees : {1e-3, 1.0, 45.0, 90.0, 170.0}) {
        const glm::uvec2 size(1280, 720);
        const double fov = degrees * 3.14159265358979323846 / 180;
        const View view = view_of(looking({1, 2, 3}, {-4, 0.5, 2}, {0.1, 1, 0.2}, fov), size);
        const glm::dmat4 clip_from_frame(view.clip_from_frame(Frame{}));
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 pixel = {unit(random) * size.x, unit(random) * size.y};
            const glm::dvec4 clip = clip_from_frame * glm::dvec4(view.direction_through(pixel), 0); // a point at infinity
            const glm::dvec2 landed = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(size);
            const LongVec meant = oracle_ray(fov, size, pixel), is = oracle_ray(fov, size, landed);
            // Each entry of the matrix is rounded by u; three rows of three such errors, met by a unit vector: at most 3 u as an angle.
            ASSERT_LE(angle_between(meant, is), 1e-7L * fov + 3 * kU) << degrees;
            ASSERT_GT(clip.w, 0);
        }
    }
}

TEST(PlanView, DepthIsReversedAndInfinite) {
    const View view = view_of(looking({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), {64, 64});
    const glm::dmat4 clip(view.clip_from_frame(Frame{}));
    const auto depth = [&](double z) {
        const glm::dvec4 p = clip * glm::dvec4(0, 0, z, 1);
        return p.z / p.w;
    };
    EXPECT_NEAR(depth(5 - view.near), 1, 1e-3); // the near plane maps to 1; eye and plane are 1e-6 apart, in floats at 5
    EXPECT_GT(depth(0), depth(-1));
    EXPECT_GT(depth(-1e15), 0);
    EXPECT_LT(depth(-1e15), 1e-20);
}

TEST(PlanView, UpIsUpAndRightIsRight) {
    const View view = view_of(looking({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), {64, 32});
    const glm::mat4 clip = view.clip_from_frame(Frame{});
    const glm::vec4 above = clip * glm::vec4(0, 1, 0, 1), right = clip * glm::vec4(1, 0, 0, 1);
    EXPECT_LT(above.y, 0); // Vulkan's clip space: y down
    EXPECT_GT(right.x, 0);
    EXPECT_LT(view.direction_through({0, 0}).x, 0);
    EXPECT_GT(view.direction_through({0, 0}).y, 0);
}

TEST(PlanView, ShiftsMoveThePictureByThatManyPixels) {
    const View view = view_of(looking({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), {640, 360});
    const auto pixel = [&](glm::dvec2 shift) {
        const glm::dvec4 p = glm::dmat4(view.clip_from_frame(Frame{}, shift)) * glm::dvec4(0.3, 0.2, 0.1, 1);
        return (glm::dvec2(p) / p.w * 0.5 + 0.5) * glm::dvec2(640, 360);
    };
    const glm::dvec2 moved = pixel({0.25, -0.5}) - pixel({0, 0});
    EXPECT_NEAR(moved.x, 0.25, 1e-4);
    EXPECT_NEAR(moved.y, -0.5, 1e-4);
}

// SC-1: the same scene in other units of length is the same picture, bit by bit, for factors of 2^k.
TEST(PlanView, PowersOfTwoKeepEveryBit) {
    const auto matrix = [](double factor) {
        Scene scene;
        scene.materials.emplace_back();
        scene.objects.push_back({Sphere{glm::dvec3(0.1, 0.2, 0.3) * factor, 1.3 * factor}});
        scene.cameras.push_back(looking(glm::dvec3(1, 2, 6) * factor, glm::dvec3(0.3, 0, 0) * factor, {0, 1, 0}));
        const View view = complete(scene, {}).completed->view;
        return view.clip_from_frame(frame_of(bounds_of(scene)));
    };
    for (int k = -30; k <= 30; ++k) EXPECT_EQ(matrix(1), matrix(std::ldexp(1.0, k))) << k;
}

// SC-2: a scene 1e5 metres from the origin lands on the same pixels.
TEST(PlanView, FarFromTheOriginNothingSwims) {
    const auto pixel = [](glm::dvec3 away) {
        Scene scene;
        scene.materials.emplace_back();
        scene.objects.push_back({Sphere{away, 1}});
        scene.cameras.push_back(looking(away + glm::dvec3(1, 2, 6), away, {0, 1, 0}));
        const View view = complete(scene, {}).completed->view;
        const Frame frame = frame_of(bounds_of(scene));
        const glm::vec4 p = view.clip_from_frame(frame) * glm::vec4(glm::vec3(frame.from_world(away + glm::dvec3(0.5, 0.25, 0.125))), 1);
        return glm::vec2(p) / p.w * glm::vec2(1280, 720) / 2.0f;
    };
    const glm::vec2 difference = pixel({0, 0, 0}) - pixel({1e5, -1e5, 1e5});
    EXPECT_LT(glm::length(difference), 1e-3f);
}

} // namespace
} // namespace lightbench
