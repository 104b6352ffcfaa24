// Area weights of a side that shrinks from n to m = max(1, n / 2) pixels: a pixel covers n / m of the level above, two or parts of three.
#include "image/mips.h"

#include <algorithm>
#include <array>

namespace lightbench {
namespace {

// Pixels first, first + 1, first + 2 of the level above, by the share of the area that each has.
struct Taps {
    unsigned first = 0, count = 1;
    std::array<double, 3> weights{1, 0, 0};
};

// Guthe, Heckbert 2005, "Non-power-of-two mipmapping" (NVIDIA): the weights (m - i, m, i + 1) / n of an odd n = 2 m + 1.
Taps taps_of(unsigned n, unsigned m, unsigned i) {
    if (n == 1) return {};
    if (n % 2 == 0) return {2 * i, 2, {0.5, 0.5, 0}};
    const double whole = n;
    return {2 * i, 3, {(m - i) / whole, m / whole, (i + 1) / whole}};
}

ImageF halved(const ImageF& in) {
    ImageF out{.width = std::max(1u, in.width / 2), .height = std::max(1u, in.height / 2), .rgba = {}};
    out.rgba.resize(std::size_t{out.width} * out.height * 4);
    std::vector<double> row(std::size_t{in.width} * 4);
    for (unsigned y = 0; y < out.height; ++y) {
        const Taps down = taps_of(in.height, out.height, y);
        std::ranges::fill(row, 0.0);
        for (unsigned k = 0; k < down.count; ++k) {
            const float* from = in.at(0, down.first + k);
            for (std::size_t i = 0; i < row.size(); ++i) row[i] += down.weights[k] * static_cast<double>(from[i]);
        }
        for (unsigned x = 0; x < out.width; ++x) {
            const Taps across = taps_of(in.width, out.width, x);
            for (std::size_t c = 0; c < 4; ++c) {
                double sum = 0;
                for (unsigned k = 0; k < across.count; ++k) sum += across.weights[k] * row[(std::size_t{across.first} + k) * 4 + c];
                out.at(x, y)[c] = static_cast<float>(sum);
            }
        }
    }
    return out;
}

} // namespace

std::vector<ImageF> mip_chain(const ImageF& image) {
    std::vector<ImageF> levels{image};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
    return levels;
}

} // namespace lightbench
