// Pictures for kernels that read them: a table of texels, read back in double. In: pictures. Out: the table, and any of its texels.
#pragma once

#include "measure/numerics/inputs.h"

#include "image/texels.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace lightbench::kernels {

// IEEE 754-2008, 3.4: what 16 bits mean.
inline double from_half(std::uint32_t h) {
    const int exponent = static_cast<int>(h >> 10 & 31), fraction = static_cast<int>(h & 1023);
    const double magnitude = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    return h >> 15 ? -magnitude : magnitude;
}

// Pictures and their table, whose first words are the pictures' TexelInfos.
struct Album {
    static constexpr std::size_t kMost = 16;
    TexelTable table{.words = std::vector<std::array<std::uint32_t, 4>>(kMost)};
    std::vector<gpu_layout::TexelInfo> infos;

    void keep(const gpu_layout::TexelInfo& info) {
        table.words.at(infos.size()) = std::bit_cast<std::array<std::uint32_t, 4>>(info);
        infos.push_back(info);
    }
    double texel(const gpu_layout::TexelInfo& t, unsigned level, unsigned column, unsigned row, std::size_t channel) const {
        const unsigned width = std::max(1u, t.width >> level), start = table.words[t.first + level / 4][level % 4];
        const std::uint32_t word = table.words[start + row * ((width + 1) / 2) + column / 2][column % 2 * 2 + channel / 2];
        return from_half(channel % 2 ? word >> 16 : word & 0xffff) * std::ldexp(1.0, static_cast<int>(t.flags >> 16) - 128);
    }
};

constexpr double kLargestTexel = 4; // of random pictures
ImageF random_picture(unsigned width, unsigned height, unsigned seed);

} // namespace lightbench::kernels
