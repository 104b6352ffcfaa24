// Directions to pictures of the surroundings against double: EN-1, EN-2, EN-3.
#include "kernel_test.h"

#include <array>
#include <cmath>
#include <numbers>

namespace lightbench::kernels {

namespace {

using Vector = std::array<double, 3>;

Inputs directions(unsigned seed, double low, double high) {
    return generate(kMillion / 2, 3, seed, [=](Random& random, std::span<float> v) {
        double d[3];
        unit_vector(random, d);
        const double length = log_uniform(random, low, high);
        for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<float>(d[i] * length);
    });
}

// The 26 directions to the faces, edges and corners of a cube, and their neighbours.
Inputs cube_directions() {
    const Inputs axis = only({0.0f, -0.0f}) + near(1, 2) + near(-1, 2);
    return axis * axis * axis;
}

Inputs scaled(Inputs in, int power) {
    for (float& x : in.values) x = std::ldexp(x, power);
    return in;
}

// Where a place of a face lies on the cube from -1 to 1.
Vector on_cube(std::span<const float> out) {
    const double a = 2 * static_cast<double>(out[1]) - 1, b = 2 * static_cast<double>(out[2]) - 1;
    const std::array<Vector, 6> places{{{1, b, a}, {-1, b, -a}, {a, 1, b}, {a, -1, -b}, {-a, b, 1}, {a, b, -1}}};
    return places.at(static_cast<std::size_t>(out[0]));
}

double off_cube(std::span<const float> d, std::span<const float> out) {
    const double largest = static_cast<double>(std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}));
    const Vector place = on_cube(out);
    double miss = 0;
    for (std::size_t i = 0; i < 3; ++i) miss = std::max(miss, std::abs(place[i] - static_cast<double>(d[i]) / largest));
    return miss;
}

double expected_face(std::span<const float> d) {
    const float x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
    const std::size_t axis = x >= y && x >= z ? 0 : (y >= z ? 1 : 2);
    return 2.0 * static_cast<double>(axis) + (d[axis] < 0 ? 1 : 0);
}

} // namespace

TEST_F(Kernel, EquirectUv) {
    expect_rows(device, "equirect_uv");
}

TEST_F(Kernel, EquirectMiddleAndSides) {
    const auto at = [&](float x, float y, float z) {
        return run_kernel(device, "equirect_uv", only({x}) * only({y}) * only({z}), 2).results;
    };
    EXPECT_EQ(at(0, 0, -1), (std::vector<float>{0.5f, 0.5f}));
    EXPECT_EQ(at(1, 0, 0), (std::vector<float>{0.75f, 0.5f}));
    EXPECT_EQ(at(-1, 0, 0), (std::vector<float>{0.25f, 0.5f}));
    EXPECT_EQ(at(0, 1, 0), (std::vector<float>{0, 1}));
    EXPECT_EQ(at(0, -1, 0), (std::vector<float>{0, 0}));
}

TEST_F(Kernel, CubeFace) {
    const Oracle face{expected_face, expected_face};
    for (unsigned seed : seeds()) {
        const Inputs in = directions(seed, 1e-30, 1e30) + cube_directions();
        Inputs some{3, {}};
        for (std::size_t i = 0; i < in.count(); ++i)
            if (in[i][0] != 0 || in[i][1] != 0 || in[i][2] != 0) some.values.insert(some.values.end(), in[i].begin(), in[i].end());
        const KernelRun run = run_kernel(device, "cube_face", some, 3);
        expect_within(run, face, Bound::exact());
        expect_within(run, constant(0), Bound::absolute(4 * kU), off_cube); // 2 u of a coordinate in [0, 1]
    }
}

// Where two faces meet, both name the same place of the cube: a step over the edge is no longer than the step of the direction.
TEST_F(Kernel, CubeFacesMeet) {
    const Inputs ends = near(1, 1);
    const KernelRun run = run_kernel(device, "cube_face", ends * ends * grid(-1, 1, 101) + ends * grid(-1, 1, 101) * ends, 3);
    expect_within(run, constant(0), Bound::absolute(6 * kU), off_cube);
}

TEST_F(Kernel, NoDirectionAtAll) {
    const float infinity = std::numeric_limits<float>::infinity();
    const Inputs axis = only({0.0f, -0.0f, kNaN, infinity, -infinity, 1});
    const Measure outside = [](std::span<const float>, std::span<const float> out) { return out[0] >= 0 && out[0] <= 5 ? 0 : 1; };
    expect_within(run_kernel(device, "cube_face", axis * axis * axis, 3), constant(0), Bound::exact(), outside);
    const KernelRun none = run_kernel(device, "cube_face", only({0.0f, -0.0f}) * only({0.0f}) * only({-0.0f}), 3);
    expect_within(none, constant(0.5), Bound::exact(), component(1));
    expect_within(none, constant(0.5), Bound::exact(), component(2));
}

// EN-2: identical for R 2^k.
TEST_F(Kernel, DirectionsOfAnyScale) {
    const Inputs in = directions(1, 1, 1) + cube_directions();
    for (const char* name : {"equirect_uv", "cube_face"}) {
        const std::size_t arity = name == std::string("cube_face") ? 3 : 2;
        const KernelRun once = run_kernel(device, name, in, arity);
        for (int power : {-100, -30, 1, 100}) EXPECT_EQ(run_kernel(device, name, scaled(in, power), arity).results, once.results) << power;
    }
}

// EN-3.
TEST_F(Kernel, Reflected) {
    const auto v_of = [](std::span<const float> in) {
        return Vector{static_cast<double>(in[3]), static_cast<double>(in[4]), static_cast<double>(in[5])};
    };
    const auto length = [](const Vector& v) { return std::hypot(v[0], v[1], v[2]); };
    const Measure off_length = [=](std::span<const float> in, std::span<const float> out) {
        return length({static_cast<double>(out[0]), static_cast<double>(out[1]), static_cast<double>(out[2])}) / length(v_of(in)) - 1;
    };
    const Measure off = [=](std::span<const float> in, std::span<const float> out) {
        const Vector n{static_cast<double>(in[0]), static_cast<double>(in[1]), static_cast<double>(in[2])}, v = v_of(in);
        const double twice = 2 * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]) / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        Vector miss{};
        for (std::size_t i = 0; i < 3; ++i) miss[i] = twice * n[i] - v[i] - static_cast<double>(out[i]);
        return length(miss) / length(v);
    };
    for (unsigned seed : seeds()) {
        const Inputs normals = directions(seed, 0.5, 2), rays = directions(seed + 100, 1e-3, 1e3);
        Inputs in{6, {}};
        for (std::size_t i = 0; i < normals.count(); ++i) {
            in.values.insert(in.values.end(), normals[i].begin(), normals[i].end());
            in.values.insert(in.values.end(), rays[i].begin(), rays[i].end());
        }
        const KernelRun run = run_kernel(device, "reflected", in, 3);
        expect_within(run, constant(0), Bound::absolute(4 * kU), off_length);
        expect_within(run, constant(0), Bound::absolute(10 * kU), off);
    }
}

} // namespace lightbench::kernels
