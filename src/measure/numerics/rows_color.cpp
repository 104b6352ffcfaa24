// sRGB and eight bits: LI-8.
#include "measure/numerics/rows.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

template <class T> T clamp_unit(T x) {
    return x > 0 ? (x < 1 ? x : T(1)) : T(0); // NaN: 0
}

template <class T> T encoded(T x) {
    using std::pow;
    const T c = clamp_unit(x);
    return c <= static_cast<double>(0.0031308f) ? T(c * 12.92) : T(1.055 * pow(c, T(1) / T(2.4)) - 0.055);
}

// All 65 536 values of 16 bits, every tie of 8 bits with its neighbours, and what does not belong.
Inputs table() {
    Inputs in = grid(0, 1, 65536) + special_values();
    for (int k = 0; k < 255; ++k) in = in + near(static_cast<float>((k + 0.5) / 255), 4);
    return in;
}

Inputs units(std::size_t count, unsigned seed) {
    return table() + generate(count, 1, seed, [](Random& random, std::span<float> x) { x[0] = static_cast<float>(uniform(random, 0, 1)); });
}

Inputs curve_inputs(std::size_t count, unsigned seed) {
    return units(count, seed) + log_grid(1e-6, 1, count / 8) + near(0.0031308f, 100);
}

const auto kSteps = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    return T(clamp_unit(in[0]) * 255);
};
const auto kEncodedSteps = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    return T(encoded(in[0]) * 255);
};

} // namespace

Rows color_rows() {
    const Oracle curve = oracle([](auto in) { return encoded(in[0]); });
    const Bound half_step = Bound::absolute(0.5 + 29 * kU * 255);
    const char* file = "lib/color.glsl";
    return {{"srgb_encode",
             file,
             "anything; [0, 1] densely",
             "srgb_encode",
             1,
             curve_inputs,
             {{"", "absolute 29 u", curve, Bound::absolute(29 * kU)}}},
            {"quantize8",
             file,
             "anything; every tie and its neighbours",
             "quantize8",
             2,
             units,
             {{"", "half a step and 1e-4", oracle(kSteps), Bound::absolute(0.5 + 1e-4)},
              {"of srgb_encode", "half a step and 29 u", oracle(kEncodedSteps), half_step, component(1)}}}};
}

} // namespace lightbench::kernels
