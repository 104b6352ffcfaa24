// Codes along the curve, bit by bit; and floats as words of the same order.
#include "kernel_test.h"

#include <bit>

namespace lightbench::kernels {

namespace {

// How many floats lie below, counted from the least.
double rank(std::span<const float> in) {
    const auto bits = std::bit_cast<std::uint32_t>(in[0]);
    const double magnitude = bits & 0x7fffffffu;
    return bits >> 31 ? 0x7fffffff - magnitude : 0x1p31 + magnitude;
}

} // namespace

TEST_F(Kernel, MortonCodesInterleaveBits) {
    expect_rows(device, "morton_code");
}

TEST_F(Kernel, OrderedWordsKeepTheOrderOfFloats) {
    Inputs in = special_values() + near(0, 100) + near(1, 100) + near(-1, 100);
    for (const unsigned seed : seeds()) in = in + random_bits(kMillion, 1, seed);
    const KernelRun run = run_kernel(device, "ordered_word", in, 3);
    const auto word = [](std::span<const float>, std::span<const float> out) { return 65536.0 * out[0] + out[1]; };
    expect_within(run, Oracle{rank, rank}, Bound::exact(), word);
    expect_within(run, constant(1), Bound::exact(), component(2));
}

} // namespace lightbench::kernels
