// Facets of rough surfaces against the slopes that they are drawn from.
#include "kernel_test.h"
#include "measure/numerics/lines.h"

#include <numbers>

namespace lightbench::kernels {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

void fill_scatter(Random& random, std::span<float> in) {
    put(in, 0, random_direction(random));
    in[3] = static_cast<float>(log_uniform(random, 1e-4, 3));
    in[4] = static_cast<float>(uniform(random, 0, 0.99999));
    in[5] = static_cast<float>(uniform(random, 0, 0.99999));
}

double expected_tangent(std::span<const float> in) {
    return static_cast<double>(in[3]) * std::sqrt(-std::log1p(-static_cast<double>(in[4])));
}

} // namespace

TEST_F(Kernel, ScatteredNormal) {
    expect_rows(device, "scattered_normal");
}

// About z, the frame is that of the axes: the azimuth is seen.
TEST_F(Kernel, ScatteredAzimuth) {
    const Inputs up = only({0}) * only({0}) * only({1});
    const KernelRun run =
        run_kernel(device, "scattered_normal", up * only({1e-3f, 0.2f, 1}) * grid(0, 0.9999, 64) * grid(0, 0.9999, 257), 3);
    const Bound bound = Bound::absolute(8 * kU);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto wanted = [=](std::span<const float> in) {
            const double t = expected_tangent(in), phi = kTurn * static_cast<double>(in[5]);
            return t / std::hypot(1.0, t) * (k == 0 ? std::cos(phi) : std::sin(phi));
        };
        expect_within(run, {wanted, wanted}, bound, component(k));
    }
}

TEST_F(Kernel, ScatteredBySlopeZero) {
    const Inputs in = generate(kMillion / 16, 6, 3, [](Random& random, std::span<float> values) {
        fill_scatter(random, values);
        values[3] = 0;
    });
    expect_within(run_kernel(device, "scattered_normal", in, 3), constant(0), Bound::exact(),
                  [](std::span<const float> n, std::span<const float> out) { return length(vec_of(out, 0) - vec_of(n, 0)); });
}

// The mean of tan^2 over all facets is slope^2, each of its two directions half of that: sums over a regular grid of xi.
TEST_F(Kernel, ScatteredSlopes) {
    constexpr std::size_t kSteps = 512;
    const Inputs middles = grid(0.5 / kSteps, 1 - 0.5 / kSteps, kSteps);
    for (float slope : {0.01f, 0.3f, 1.0f}) {
        const KernelRun run =
            run_kernel(device, "scattered_normal", only({0}) * only({0}) * only({1}) * only({slope}) * middles * middles, 3);
        double xx = 0, yy = 0, xy = 0;
        for (std::size_t i = 0; i < run.inputs.count(); ++i) {
            const Vec3 h = vec_of(run.result(i), 0);
            xx += h.x / h.z * (h.x / h.z);
            yy += h.y / h.z * (h.y / h.z);
            xy += h.x / h.z * (h.y / h.z);
        }
        const double n = static_cast<double>(run.inputs.count()), half = 0.5 * static_cast<double>(slope) * static_cast<double>(slope);
        EXPECT_NEAR(xx / n / half, 1, 2e-3) << slope; // the grid leaves out the far tail of -log(1 - xi)
        EXPECT_NEAR(yy / n / half, 1, 2e-3) << slope;
        EXPECT_NEAR(xy / n / half, 0, 1e-4) << slope;
    }
}

} // namespace lightbench::kernels
