// Tilted normals and tangent frames against double: BM-2, BM-3.
#include "kernel_test.h"
#include "measure/numerics/frames.h"

namespace lightbench::kernels::frames {

namespace {

Inputs vec(float x, float y, float z) {
    return only({x}) * only({y}) * only({z});
}

void expect_frame(const KernelRun& run) {
    expect_claims(run, "tangent_frame");
}

} // namespace

TEST_F(Kernel, PerturbNormal) {
    expect_rows(device, "perturb_normal");
}

// BM-3: n is what a bump made of the geometric normal, which faces the viewer.
TEST_F(Kernel, KeepFacing) {
    expect_rows(device, "keep_facing");
}

TEST_F(Kernel, KeepFacingFallsBack) {
    const Inputs up = vec(0, 0, 1), down = vec(0, 0, -1), side = vec(1, 0, 0);
    const KernelRun run = run_kernel(device, "keep_facing", down * side * up + up * side * down, 3);
    EXPECT_EQ(run.results, (std::vector<float>{1, 0, 0, 1, 0, 0}));
}

TEST_F(Kernel, TangentFrame) {
    expect_rows(device, "tangent_frame");
}

// BM-2: no area in uv, t along n, anything that a file may hold.
TEST_F(Kernel, TangentFrameOfAnything) {
    const Inputs normals = vec(0, 0, 1) + vec(0, 0, -1) + vec(1, 0, 0) + vec(0, -1, 0) + vec(0.6f, 0, 0.8f) + vec(-0.6f, 0, -0.8f);
    const Inputs special = special_values();
    const Inputs hands = only({1, -1});
    expect_frame(run_kernel(device, "tangent_frame", normals * (special * special * special) * hands, 6));
    expect_frame(run_kernel(device, "tangent_frame", normals * random_bits(kMillion / 8, 3, 1) * hands, 6));
    const Inputs units = generate(1000, 7, 1, fill_frame);
    Inputs parallel{7, {}};
    for (std::size_t i = 0; i < units.count(); ++i)
        for (float factor : {1.0f, -1.0f, 1e-30f, 3.0f, 0.0f}) {
            const std::span<const float> n = units[i].first(3);
            for (float x : {n[0], n[1], n[2], n[0] * factor, n[1] * factor, n[2] * factor, units[i][6]}) parallel.values.push_back(x);
        }
    expect_frame(run_kernel(device, "tangent_frame", parallel, 6));
}

// Where t is well away from n, the first axis is t less its part along n.
TEST_F(Kernel, TangentFrameKeepsTheDirection) {
    const Inputs in = generate(kMillion / 2, 7, 3, [](Random& random, std::span<float> values) {
        do fill_frame(random, values);
        while (std::abs(dot(at(values, 0), unit(at(values, 3)))) > 0.99);
    });
    expect_within(run_kernel(device, "tangent_frame", in, 6), constant(0), Bound::absolute(64 * kU),
                  [](std::span<const float> values, std::span<const float> out) {
                      const Vector n = unit(at(values, 0)), t = unit(at(values, 3));
                      return length(plus(at(out, 0), unit(plus(t, n, -dot(n, t))), -1));
                  });
}

// n less the gradient is the normal that the texel says: x along t, y along b, z along n.
TEST_F(Kernel, NormalMapGradient) {
    expect_rows(device, "normal_map_gradient");
}

// Level, backward and empty texels: slopes end at 128.
TEST_F(Kernel, NormalMapOfAnything) {
    const Inputs byte = grid(0, 1, 52);
    const KernelRun run = run_kernel(device, "normal_map_gradient", byte * byte * byte * vec(1, 0, 0) * vec(0, 1, 0) * only({1, 0}), 3);
    expect_within(run, constant(0), Bound::exact(), [](std::span<const float>, std::span<const float> out) {
        return std::abs(out[0]) <= 128.01f && std::abs(out[1]) <= 128.01f ? 0 : 1;
    });
}

} // namespace lightbench::kernels::frames
