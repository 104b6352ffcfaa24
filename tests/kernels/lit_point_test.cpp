// A point lit by one light, composed from the functions as a shader composes them: LI-5, LI-7.
#include "kernel_test.h"

#include <bit>
#include <cmath>

namespace lightbench::kernels {

namespace {

void put_unit(Random& random, std::span<float> out) {
    double v[3];
    unit_vector(random, v);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(v[i]);
}

// (n, v, vector to the light, Ip, shininess, kd)
Inputs lit_points(std::size_t count, unsigned seed) {
    return generate(count, 12, seed, [](Random& random, std::span<float> in) {
        for (std::size_t at : {0u, 3u, 6u}) put_unit(random, in.subspan(at, 3));
        const double distance = log_uniform(random, 1e-3, 1e3);
        for (std::size_t i = 6; i < 9; ++i) in[i] *= static_cast<float>(distance);
        in[9] = static_cast<float>(log_uniform(random, 1e-2, 1e2));
        in[10] = static_cast<float>(log_uniform(random, 1, 1000));
        in[11] = static_cast<float>(uniform(random, 0, 1));
    });
}

} // namespace

// LI-5: the light in the point itself, or nearer than a float can square.
TEST_F(Kernel, LightAtThePoint) {
    Inputs in = lit_points(1000, 1);
    Inputs close{12, {}};
    for (float distance : {0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-10f})
        for (std::size_t i = 0; i < in.count(); ++i) {
            close.values.insert(close.values.end(), in[i].begin(), in[i].end());
            for (std::size_t k = 6; k < 9; ++k) close.values[close.values.size() - 12 + k] *= distance;
        }
    const KernelRun run = run_kernel(device, "lit_point", close, 3);
    expect_within(run, constant(0), Bound::exact(),
                  [](std::span<const float>, std::span<const float> out) { return std::isfinite(out[0] + out[1] + out[2]) ? 0.0 : 1.0; });
}

// LI-7: 2^k times the light is 2^k times the radiance, to the bit: no hidden epsilon, no early clamp.
TEST_F(Kernel, LinearInTheLight) {
    const Inputs in = lit_points(1u << 17, 1);
    const KernelRun once = run_kernel(device, "lit_point", in, 3);
    ASSERT_EQ(once.missing, 0u);
    for (int power : {-20, -1, 1, 30}) {
        Inputs scaled = in;
        for (std::size_t i = 9; i < scaled.values.size(); i += 12) scaled.values[i] = std::ldexp(scaled.values[i], power);
        const KernelRun more = run_kernel(device, "lit_point", scaled, 3);
        ASSERT_EQ(more.missing, 0u);
        std::size_t different = 0, compared = 0;
        for (std::size_t i = 0; i < once.results.size(); ++i) {
            const float wanted = std::ldexp(once.results[i], power);
            if (std::abs(once.results[i]) < 1e-28f) continue; // products on the way may have been denormal
            ++compared;
            different += std::bit_cast<std::uint32_t>(wanted) != std::bit_cast<std::uint32_t>(more.results[i]);
        }
        EXPECT_GT(compared, in.count());
        EXPECT_EQ(different, 0u) << "of " << compared << ", light times 2^" << power;
    }
}

} // namespace lightbench::kernels
