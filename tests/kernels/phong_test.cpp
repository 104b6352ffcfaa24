// Lambert's and Phong's factors against their formulas in double and 60 digits: LI-1, LI-2, LI-3.
#include "kernel_test.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

void put(std::span<float> out, const double (&v)[3]) {
    const double length = std::hypot(v[0], v[1], v[2]);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i] / length);
}

Inputs vec(float x, float y, float z) {
    return only({x}) * only({y}) * only({z});
}

Inputs random_units(std::size_t count, unsigned seed, bool below) {
    return generate(count, 3, seed, [=](Random& random, std::span<float> v) {
        double d[3];
        unit_vector(random, d);
        if (below) d[2] = -std::abs(d[2]);
        put(v, d);
    });
}

} // namespace

TEST_F(Kernel, Lambert) {
    expect_rows(device, "lambert");
}

TEST_F(Kernel, PhongSpecular) {
    expect_rows(device, "phong_specular");
}

// LI-2: the corners of 0^0, 0^n and (negative)^n, by geometry that is exact in float.
TEST_F(Kernel, SpecularSpecialValues) {
    const Inputs up = vec(0, 0, 1), side = vec(1, 0, 0), down = vec(0, 0, -1), slant = vec(0.6f, 0, 0.8f), mirror = vec(-0.6f, 0, 0.8f);
    const Inputs exponents = only({0, 1e-30f, 1, 200, 1000, 100000, 1e20f, kFloatMax});
    const Inputs full = up * (up * up + slant * mirror + mirror * slant) * exponents; // R = V
    expect_within(run_kernel(device, "phong_specular", full), constant(1), Bound::exact());
    const Inputs none = up * (up * side + up * down + down * up + side * mirror + down * slant) * exponents;
    expect_within(run_kernel(device, "phong_specular", none), constant(0), Bound::exact());
    const Inputs flat = up * up * slant * only({0}) + up * slant * up * only({0}); // lit, R.V > 0, n = 0
    expect_within(run_kernel(device, "phong_specular", flat), constant(1), Bound::exact());
}

// LI-3: no highlight leaks through a surface that is lit from behind, though R.V may be 1 there.
TEST_F(Kernel, NoHighlightFromBehind) {
    const Inputs in = vec(0, 0, 1) * random_units(1024, 1, true) * random_units(1024, 2, false) * only({1});
    expect_within(run_kernel(device, "phong_specular", in), constant(0), Bound::exact());
}

TEST_F(Kernel, PhongKeepsNaN) {
    const Inputs bad = vec(kNaN, 0, 1), up = vec(0, 0, 1);
    const Oracle nan = constant(static_cast<double>(kNaN));
    const Inputs in = (bad * up * up + up * bad * up + up * up * bad) * only({0, 1, 1000}) + up * up * up * only({kNaN});
    expect_within(run_kernel(device, "phong_specular", in), nan, Bound::exact());
    expect_within(run_kernel(device, "lambert", bad * up + up * bad), nan, Bound::exact());
}

} // namespace lightbench::kernels
