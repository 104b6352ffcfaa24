// Codes along the curve, bit by bit; and floats as words of the same order.
#include "kernel_test.h"

#include <bit>

namespace lightbench::kernels {

namespace {

double interleaved(std::span<const float> cell) {
    std::uint32_t code = 0;
    for (int bit = 9; bit >= 0; --bit)
        for (int axis = 0; axis < 3; ++axis)
            code = 2 * code + (static_cast<std::uint32_t>(cell[static_cast<std::size_t>(axis)]) >> bit & 1u);
    return code;
}

// How many floats lie below, counted from the least.
double rank(std::span<const float> in) {
    const auto bits = std::bit_cast<std::uint32_t>(in[0]);
    const double magnitude = bits & 0x7fffffffu;
    return bits >> 31 ? 0x7fffffff - magnitude : 0x1p31 + magnitude;
}

} // namespace

TEST_F(Kernel, MortonCodesInterleaveBits) {
    Inputs in = grid(0, 1023, 1024) * only({0, 1, 341, 682, 1023}) * only({0, 512, 1023}) + only({7}) * grid(0, 1023, 1024) * only({3}) +
                only({1, 1022}) * only({5}) * grid(0, 1023, 1024);
    for (const unsigned seed : seeds())
        in = in + generate(kMillion, 3, seed, [](Random& random, std::span<float> cell) {
                 for (float& x : cell) x = static_cast<float>(random() % 1024);
             });
    const auto code = [](std::span<const float>, std::span<const float> out) { return 32768.0 * out[0] + out[1]; };
    expect_within(run_kernel(device, "morton", in, 2), Oracle{interleaved, interleaved}, Bound::exact(), code);
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
