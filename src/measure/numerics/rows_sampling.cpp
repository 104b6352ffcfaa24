// What sampling adds up and weighs: random numbers, the filter, compensated sums, codes along the curve.
#include "measure/numerics/rows.h"

#include <cmath>

namespace lightbench::kernels {

namespace {

// Weights of samples (AA-4). (x, y, radius, sigma)
const auto kBell = [](auto in) {
    using T = std::remove_cvref_t<decltype(in[0])>;
    const T r2 = in[0] * in[0] + in[1] * in[1], end2 = in[2] * in[2], width = 2 * in[3] * in[3];
    return r2 < end2 ? T(exp(-r2 / width) - exp(-end2 / width)) : T(0);
};

Inputs weighed(std::size_t count, unsigned) {
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 6));
    const Inputs shape = only({1.5f}) * only({0.5f}) + only({1}) * only({0.001f, 0.2f, 1000}) + only({3}) * only({0.7f, 2});
    return (grid(-3.1, 3.1, side) * grid(-3.1, 3.1, side) + near(1.5f, 20) * near(0, 2) + only({0}) * only({0})) * shape;
}

// Jarzynski, Olano 2020, "Hash functions for GPU rendering", pcg4d; the upper 24 bits of its words.
double random_number(std::span<const float> key, std::size_t which) {
    std::uint32_t v[4];
    for (std::size_t i = 0; i < 4; ++i) v[i] = static_cast<std::uint32_t>(key[i]) * 1664525u + 1013904223u;
    const auto stir = [&] {
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
    };
    stir();
    for (std::uint32_t& x : v) x ^= x >> 16;
    stir();
    return (v[which] >> 8) * 0x1p-24;
}

Row random_row() {
    Row row{"random_unit4", "lib/random.glsl", "keys of four integers below 2^24", "random_unit4", 4, {}, {}};
    row.inputs = [](std::size_t count, unsigned seed) {
        return generate(count, 4, seed, [](Random& random, std::span<float> key) {
            for (float& x : key) x = static_cast<float>(random() >> 40);
        });
    };
    const auto number = [](std::size_t i) { return [=](std::span<const float> key) { return random_number(key, i); }; };
    for (std::size_t i = 0; i < 4; ++i)
        row.claims.push_back({std::string(1, "xyzw"[i]), "exact", {number(i), number(i)}, Bound::exact(), component(i)});
    return row;
}

// One bright term, then faint ones that a plain sum never takes note of.
Inputs sums(std::size_t count, unsigned seed) {
    return generate(count / 64, 3, seed, [](Random& random, std::span<float> in) {
        in[1] = static_cast<float>(log_uniform(random, 1e-6, 1));
        in[0] = in[1] * static_cast<float>(log_uniform(random, 1, 1e9));
        in[2] = static_cast<float>(random() % 4096);
    });
}

double interleaved(std::span<const float> cell) {
    std::uint32_t code = 0;
    for (int bit = 9; bit >= 0; --bit)
        for (int axis = 0; axis < 3; ++axis)
            code = 2 * code + (static_cast<std::uint32_t>(cell[static_cast<std::size_t>(axis)]) >> bit & 1u);
    return code;
}

Inputs cells(std::size_t count, unsigned seed) {
    return grid(0, 1023, 1024) * only({0, 1, 341, 682, 1023}) * only({0, 512, 1023}) + only({7}) * grid(0, 1023, 1024) * only({3}) +
           only({1, 1022}) * only({5}) * grid(0, 1023, 1024) + generate(count, 3, seed, [](Random& random, std::span<float> cell) {
               for (float& x : cell) x = static_cast<float>(random() % 1024);
           });
}

double contrast_of(std::span<const float> in) {
    const double high = static_cast<double>(in[0]), low = static_cast<double>(in[1]);
    return high + low > 0 ? (high - low) / (high + low) : 0;
}
double is_rough(std::span<const float> in) {
    return contrast_of(in) > static_cast<double>(in[2]) ? 1 : 0;
}
double about_threshold(std::span<const float> in, double) {
    return std::abs(contrast_of(in) / static_cast<double>(in[2]) - 1) < 3 * kU ? 1 : 0;
}

Inputs extremes(std::size_t count, unsigned seed) {
    return generate(count, 3, seed, [](Random& random, std::span<float> in) {
        in[2] = static_cast<float>(uniform(random, 0.05, 0.9));
        const double c = random() % 2 ? static_cast<double>(in[2]) * (1 + uniform(random, -1e-6, 1e-6)) : uniform(random, 0, 1);
        in[0] = static_cast<float>(log_uniform(random, 1e-30, 1e30));
        in[1] = static_cast<float>(static_cast<double>(in[0]) * (1 - c) / (1 + c));
        if (random() % 16 == 0) in[0] = in[1] = 0;
    });
}

} // namespace

Rows sampling_rows() {
    const Measure whole = [](std::span<const float>, std::span<const float> out) {
        return 32768.0 * static_cast<double>(out[0]) + static_cast<double>(out[1]);
    };
    return {random_row(),
            {"filter_gaussian",
             "lib/filter.glsl",
             "radius in [1, 3], sigma in [1e-3, 1e3]",
             "filter_gaussian",
             1,
             weighed,
             {{"", "absolute 4 u", oracle(kBell), Bound::absolute(4 * kU)}}},
            {"sum_add",
             "lib/sum.glsl",
             "to 4095 terms after one to 1e9 times as large",
             "sum_add",
             1,
             sums,
             {{"", "relative 8 u", oracle([](auto in) { return in[0] + in[1] * in[2]; }), Bound::relative(8 * kU)}}},
            {"contrast_exceeds",
             "lib/contrast.glsl",
             "intensities in [1e-30, 1e30], 0",
             "contrast_exceeds",
             1,
             extremes,
             {{"", "exact, but within relative 3 u of the threshold", {is_rough, is_rough}, Bound::function(about_threshold)}}},
            {"morton_code",
             "lib/morton.glsl",
             "cells to 1023",
             "morton",
             2,
             cells,
             {{"", "exact", {interleaved, interleaved}, Bound::exact(), whole}}}};
}

} // namespace lightbench::kernels
